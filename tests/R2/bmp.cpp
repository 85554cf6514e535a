#include <gtest/gtest.h>

#include <cmath>

#include "tests/R2/image_bytes.h"

namespace R2 {

namespace {

Bytes Little(std::uint32_t number) {
  return {static_cast<unsigned char>(number), static_cast<unsigned char>(number >> 8),
          static_cast<unsigned char>(number >> 16), static_cast<unsigned char>(number >> 24)};
}

/// Makes both headers by hand; `offset` is the start of the pixels.
Bytes Headers(std::uint32_t offset, std::uint32_t width, std::uint32_t height, unsigned char bits,
              std::uint32_t compression = 0, std::uint32_t colors = 0) {
  return ToBytes("BM") + Little(0) + Little(0) + Little(offset) + Little(40) + Little(width) + Little(height) +
         Bytes{1, 0, bits, 0} + Little(compression) + Little(0) + Little(0) + Little(0) + Little(colors) + Little(0);
}

// Blue, green, red; rows padded to eight bytes.
const Bytes first_row{255, 0, 0, 0, 255, 0, 0, 0};
const Bytes second_row{0, 0, 255, 255, 255, 255, 0, 0};

}  // namespace

TEST(Bmp, TheFirstRowIsTheBottomOne) {
  const Image image = DecodeImage(Headers(54, 2, 2, 24) + first_row + second_row).image;
  EXPECT_EQ(image.At(0, 0), (Color{0, 0, 1}));
  EXPECT_EQ(image.At(1, 0), (Color{0, 1, 0}));
  EXPECT_EQ(image.At(0, 1), (Color{1, 0, 0}));
  EXPECT_EQ(image.At(1, 1), (Color{1, 1, 1}));
}

TEST(Bmp, ANegativeHeightPutsTheFirstRowOnTop) {
  const Image image = DecodeImage(Headers(54, 2, 0u - 2, 24) + first_row + second_row).image;
  ASSERT_EQ(image.Height(), 2);
  EXPECT_EQ(image.At(0, 1), (Color{0, 0, 1}));
  EXPECT_EQ(image.At(0, 0), (Color{1, 0, 0}));
}

TEST(Bmp, IsWrittenByteForByteAsTheFormatSays) {
  const Bytes plain = Headers(54, 2, 2, 24) + first_row + second_row;
  Bytes expected = plain;
  expected[2] = static_cast<unsigned char>(plain.size());
  expected[34] = 16;                   // bytes of the pixels
  expected[38] = expected[42] = 0x13;  // 2835 dots per meter
  expected[39] = expected[43] = 0x0b;
  EXPECT_EQ(Format("bmp").encode(DecodeImage(plain).image, {}, {}), expected);
}

TEST(Bmp, PixelsOf32BitsContainBgrAndAnIgnoredByte) {
  const Image image = DecodeImage(Headers(54, 1, 1, 32) + Bytes{51, 102, 255, 7}).image;
  EXPECT_EQ(ToByte(image.At(0, 0).r), 255);
  EXPECT_EQ(ToByte(image.At(0, 0).g), 102);
  EXPECT_EQ(ToByte(image.At(0, 0).b), 51);
}

TEST(Bmp, BitFieldsSelectTheBitsOfAChannel) {
  const auto pixel = [](unsigned char bits, const Bytes& masks, const Bytes& bytes) {
    return DecodeImage(Headers(54 + static_cast<std::uint32_t>(masks.size()), 1, 1, bits, 3) + masks + bytes)
        .image.At(0, 0);
  };
  const Bytes four{51, 102, 255, 7};
  const auto near = [](const Color& a, const Color& b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) < 1e-6;
  };
  EXPECT_TRUE(near(pixel(32, Little(0xff0000) + Little(0xff00) + Little(0xff), four), {1, 0.4, 0.2}));
  EXPECT_TRUE(near(pixel(32, Little(0xff) + Little(0xff00) + Little(0xff0000), four), {0.2, 0.4, 1}));
  EXPECT_TRUE(near(pixel(32, Little(0xff000000) + Little(0xff0000) + Little(0xff00), four), {7 / 255.0, 1, 0.4}));
  EXPECT_TRUE(near(pixel(32, Little(0xfffff) + Little(0) + Little(0), {0, 0, 8, 0}), {0x80000 / 1048575.0, 0, 0}));
  EXPECT_TRUE(
      near(pixel(16, Little(0xf800) + Little(0x7e0) + Little(0x1f), {0x2a, 0x55}), {10 / 31.0, 41 / 63.0, 10 / 31.0}));
  // Five bits per channel by default.
  EXPECT_TRUE(
      near(DecodeImage(Headers(54, 1, 1, 16) + Bytes{0x2a, 0x55}).image.At(0, 0), {21 / 31.0, 9 / 31.0, 10 / 31.0}));
  EXPECT_NE(Complaint(Headers(66, 1, 1, 32, 3) + Little(0xff00ff) + Little(0xff00) + Little(0xff000000) + four), "");
  EXPECT_NE(Complaint(Headers(66, 1, 1, 32, 3) + Little(0xff) + Little(0xff) + Little(0xff00) + four), "");
  EXPECT_NE(Complaint(Headers(66, 1, 1, 32, 3) + Bytes(12) + four), "");
}

// Many writers set a mask for alpha and leave alpha at zero.
TEST(Bmp, TransparentPixelsAreReportedUnlessAllAreOrNoneIs) {
  const Bytes masks = Little(0xff0000) + Little(0xff00) + Little(0xff) + Little(0xff000000);
  const auto warnings = [&](unsigned char first, unsigned char second) {
    return DecodeImage(Headers(70, 2, 1, 32, 6) + masks + Bytes{1, 2, 3, first, 1, 2, 3, second}).warnings.size();
  };
  EXPECT_EQ(warnings(0, 0), 0u);
  EXPECT_EQ(warnings(255, 255), 0u);
  EXPECT_EQ(warnings(255, 0), 1u);
  EXPECT_EQ(warnings(128, 128), 1u);
}

/// Makes an image of 4 by 3 pixels with a gray palette and run lengths.
DecodedImage ReadRuns(const Bytes& runs, unsigned char bits = 8) {
  Bytes palette;
  for (unsigned char i = 0; i < 16; ++i) palette = palette + Bytes{i, i, i, 0};
  return DecodeImage(Headers(54 + 64, 4, 3, bits, bits == 8 ? 1 : 2, 16) + palette + runs);
}

/// Returns the palette indices of a row, counted from the bottom, as letters.
std::string Row(const Image& image, int y) {
  std::string row;
  for (int x = 0; x < image.Width(); ++x) row += static_cast<char>('a' + ToByte(image.At(x, y).r));
  return row;
}

TEST(Bmp, RunsStretchesAndStepsAreRead) {
  const DecodedImage decoded = ReadRuns({3, 1, 1, 2, 0, 0,              // bbbc
                                         0, 3, 4, 5, 6, 0, 0, 2, 0, 1,  // efg, padded to an even number; a step up
                                         1, 9, 0, 1});
  EXPECT_TRUE(decoded.warnings.empty());
  EXPECT_EQ(Row(decoded.image, 0), "bbbc");
  EXPECT_EQ(Row(decoded.image, 1), "efga");
  EXPECT_EQ(Row(decoded.image, 2), "aaaj");
  const Image four = ReadRuns({4, 0x12, 0, 0, 0, 3, 0x34, 0x50, 1, 0x60, 0, 0, 0, 2, 1, 0, 3, 0x77, 0, 1}, 4).image;
  EXPECT_EQ(Row(four, 0), "bcbc");
  EXPECT_EQ(Row(four, 1), "defg");
  EXPECT_EQ(Row(four, 2), "ahhh");
  // Rows padded to four bytes, as some writers encode them.
  const DecodedImage filled = ReadRuns({8, 0x11, 0, 0, 0, 0, 8, 0x22, 0, 1}, 4);
  EXPECT_TRUE(filled.warnings.empty());
  EXPECT_EQ(Row(filled.image, 0) + Row(filled.image, 1) + Row(filled.image, 2), "bbbbaaaacccc");
}

TEST(Bmp, TheEndMarkMayBeMissing) {
  EXPECT_TRUE(ReadRuns({4, 1, 0, 0, 4, 2, 0, 0, 4, 3}).warnings.empty());
  EXPECT_TRUE(ReadRuns({4, 1, 0, 0, 4, 2, 0, 0, 4, 3, 0, 0}).warnings.empty());
  EXPECT_TRUE(ReadRuns({4, 1, 0, 0, 4, 2, 0, 0, 4, 3, 0, 0, 0, 1}).warnings.empty());
  EXPECT_EQ(ReadRuns({4, 1, 0, 1, 7, 7}).warnings.size(), 1u);  // bytes after it
}

// A program that trusts a run writes beyond its memory.
TEST(Bmp, OverlongRunsAreCutWithAWarning) {
  for (const Bytes& runs : {Bytes{255, 1, 0, 1}, Bytes{3, 1, 0, 4, 2, 2, 2, 2, 0, 1}, Bytes{0, 2, 200, 0, 1, 1, 0, 1},
                            Bytes{0, 2, 0, 200, 1, 1, 0, 1}, Bytes{0, 2, 255, 255}}) {
    const DecodedImage decoded = ReadRuns(runs);
    ASSERT_FALSE(decoded.warnings.empty());
    EXPECT_EQ(decoded.warnings[0], "BMP is damaged: a run goes beyond its row or the image, and is cut there");
    EXPECT_EQ(Row(decoded.image, 2), "aaaa");
  }
}

TEST(Bmp, RunLengthsThatEndBeforeTheImageAreRefused) {
  const auto complaint = [](const Bytes& runs) {
    try {
      ReadRuns(runs);
    } catch (const ImageError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const Bytes whole{3, 1, 1, 2, 0, 0, 0, 4, 4, 5, 6, 7, 0, 0, 4, 9};
  EXPECT_EQ(complaint(whole), "");
  for (std::ptrdiff_t length = 0; length < std::ssize(whole); ++length)
    EXPECT_EQ(complaint({whole.begin(), whole.begin() + length}).substr(0, 17), "BMP is truncated:") << length;
  EXPECT_EQ(complaint({4, 16, 0, 1}), "BMP has a pixel that is not in its palette");
}

// K4: a few bytes whose steps skip everything.
TEST(Extremes, K4_RunLengthsThatSkipMillionsOfPixelsAreRefused) {
  EXPECT_NE(Complaint(Headers(54, 16000, 16000, 8, 1) + Bytes(1024) + Bytes{0, 1}).find("cannot come out of 2 bytes"),
            std::string::npos);
}

TEST(Bmp, AProfileAfterThePixelsIsNotSurplus) {
  Bytes header = ToBytes("BM") + Little(0) + Little(0) + Little(14 + 124) + Little(124) + Little(1) + Little(1) +
                 Bytes{1, 0, 24, 0} + Bytes(124 - 16);
  const Bytes pixel{1, 2, 3, 0};
  EXPECT_EQ(DecodeImage(header + pixel + Bytes(100)).warnings.size(), 1u);
  header[14 + 116] = 100;
  EXPECT_EQ(DecodeImage(header + pixel + Bytes(100)).warnings.size(), 0u);
}

TEST(Bmp, PalettesAreReadAndPixelsBeyondThemRefused) {
  const Bytes palette = Bytes{0, 0, 255, 0} + Bytes{255, 0, 0, 0};
  const Bytes headers = Headers(62, 2, 1, 8, 0, 2);
  const Image image = DecodeImage(headers + palette + Bytes{1, 0, 0, 0}).image;
  EXPECT_EQ(image.At(0, 0), (Color{0, 0, 1}));
  EXPECT_EQ(image.At(1, 0), (Color{1, 0, 0}));
  EXPECT_NE(Complaint(headers + palette + Bytes{2, 0, 0, 0}), "");
}

TEST(Bmp, UnsupportedFeaturesAreNamed) {
  EXPECT_EQ(
      Complaint(Headers(54, 1, 1, 24, 1) + Bytes(2000)),
      "BMP has compression 1 with 24 bits per pixel; run lengths of 8 and 4 bits and bit fields of 16 and 32 bits are "
      "read");
  EXPECT_EQ(Complaint(Headers(54, 1, 1, 0, 4) + Bytes(2000)),
            "BMP contains a JPEG instead of pixels, which is not supported");
  EXPECT_EQ(Complaint(Headers(54, 1, 1, 0, 5) + Bytes(2000)),
            "BMP contains a PNG instead of pixels, which is not supported");
  EXPECT_EQ(Complaint(Headers(54, 1, 1, 7) + Bytes(2000)),
            "BMP has 7 bits per pixel; 1, 2, 4, 8, 16, 24 and 32 are read");
  EXPECT_NE(Complaint(Headers(54, 0, 1, 24) + Bytes(2000)), "");
  EXPECT_NE(Complaint(Headers(0xffffffff, 1, 1, 24) + Bytes(2000)), "");
  EXPECT_NE(Complaint(Headers(54, 1, 0x80000000, 24) + Bytes(2000)), "");
}

}  // namespace R2
