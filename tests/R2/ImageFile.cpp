#include "R2/ImageFile.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "tests/R2/image_bytes.h"

namespace R2 {

namespace {

// The maximum error of a channel in [0, 1] after writing and reading.
double StepOf(const ImageFormat& format, const ImageEncoding& encoding) {
  const std::string name = format.name;
  if (name == "jpeg") return 6 / 255.0;  // quality 100 below: the rounding of colors and of coefficients
  if (name == "hdr") return 0.5 / 128;   // half a step of the largest channel's mantissa
  if (format.is_linear) return 0;
  return name == "png" && encoding.bits == 16 ? 0.5 / 65535 + 1e-7 : 0.5 / 255 + 1e-7;  // and a float's rounding
}

double LargestDifference(const Image& a, const Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.Channels().size(); ++i)
    largest = std::max(largest, std::abs(double{a.Channels()[i]} - double{b.Channels()[i]}));
  return largest;
}

const ImageSettings some_settings{{"program", "raypro 0.1"},
                                  {"command", "raypro a.scn\n-width 5 \\n : C:\\dir\r\nend"},
                                  {"title", "Kugel f\xc3\xbcr Zo\xc3\xab \xe2\x98\x83"},
                                  {"seed", ""}};

}  // namespace

// Otherwise the image itself would be lost.
TEST(ImageFile, EveryFormatGivesBackWhatItWrote) {
  for (const ImageFormat& format : ImageFormats()) {
    for (const int bits : {8, 16}) {
      for (const ImageSize size : {ImageSize{1, 1}, {7, 5}, {16, 16}, {1, 9}, {131, 3}}) {
        SCOPED_TRACE(std::string(format.name) + " " + std::to_string(size.width) + " x " + std::to_string(size.height));
        const ImageEncoding encoding{.bits = bits, .jpeg_quality = 100};
        const Image image = Gradient(size.width, size.height);
        const Bytes bytes = format.encode(image, encoding, {});
        const DecodedImage decoded = DecodeImage(bytes);
        EXPECT_EQ(decoded.format, &format);
        ASSERT_EQ(decoded.image.Width(), size.width);
        ASSERT_EQ(decoded.image.Height(), size.height);
        EXPECT_LE(LargestDifference(decoded.image, image), StepOf(format, encoding));
        EXPECT_EQ(ReadImageSize(bytes).width, size.width);
        EXPECT_EQ(ReadImageSize(bytes).height, size.height);
      }
    }
  }
}

// An image that is upside down or mirrored has the correct size and histogram, so this is tested separately.
TEST(ImageFile, TheBottomLeftCornerStaysAtTheBottomLeft) {
  for (const ImageFormat& format : ImageFormats()) {
    SCOPED_TRACE(format.name);
    Image image(32, 48);
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 16; ++x) image.Set(x, y, {1, 1, 1});
    const Image decoded = DecodeImage(format.encode(image, {}, {})).image;
    EXPECT_GT(decoded.At(2, 2).g, 0.9);
    EXPECT_LT(decoded.At(29, 2).g, 0.1);
    EXPECT_LT(decoded.At(2, 45).g, 0.1);
    EXPECT_LT(decoded.At(29, 45).g, 0.1);
  }
}

TEST(ImageFile, RedGreenAndBlueDoNotChangePlaces) {
  for (const ImageFormat& format : ImageFormats()) {
    SCOPED_TRACE(format.name);
    Image image(16, 16);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) image.Set(x, y, {0.75, 0.5, 0.25});
    const Color c = DecodeImage(format.encode(image, {}, {})).image.At(8, 8);
    EXPECT_NEAR(c.r, 0.75, 0.01);
    EXPECT_NEAR(c.g, 0.5, 0.01);
    EXPECT_NEAR(c.b, 0.25, 0.01);
  }
}

// Without settings nobody can reproduce the image.
TEST(ImageFile, SettingsSurviveInJpegPngAndExr) {
  int formats_with_settings = 0;
  for (const ImageFormat& format : ImageFormats()) {
    const std::string name = format.name;
    if (name != "jpeg" && name != "png" && name != "exr") continue;
    ++formats_with_settings;
    const ImageSettings read = DecodeImage(format.encode(Gradient(3, 2), {}, some_settings)).settings;
    EXPECT_EQ(read, some_settings) << name;
    EXPECT_TRUE(DecodeImage(format.encode(Gradient(3, 2), {}, {})).settings.empty()) << name;
    const ImageHeader header = ReadImageHeader(format.encode(Gradient(3, 2), {}, some_settings));
    EXPECT_EQ(header.settings, some_settings) << name;
    EXPECT_EQ(header.format->name, std::string(name));
    EXPECT_EQ(header.size.width * 10 + header.size.height, 32) << name;
  }
  EXPECT_GE(formats_with_settings, 2);
}

TEST(ImageFile, SettingsThatCannotBeStoredDoNotPreventWriting) {
  const ImageSettings odd{{"", "no key"},
                          {std::string(300, 'k'), "long key"},
                          {"zero", std::string("a\0b", 3)},
                          {"channels", "a name the format has"},
                          {"a: b\n", "c"}};
  for (const ImageFormat& format : ImageFormats()) {
    const Image image = Gradient(3, 2);
    EXPECT_EQ(DecodeImage(format.encode(image, {}, odd)).image, DecodeImage(format.encode(image, {}, {})).image)
        << format.name;
  }
}

// K9: an interrupted download, a full disk.
TEST(ImageFile, ATruncatedFileIsRefusedOrStillComplete) {
  for (const ImageFormat& format : ImageFormats()) {
    const Bytes bytes = format.encode(Gradient(9, 3), {}, {{"seed", "7"}});
    const Image whole = DecodeImage(bytes).image;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      SCOPED_TRACE(std::string(format.name) + " cut to " + std::to_string(length));
      try {
        const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_EQ(DecodeImage(cut).image, whole);
      } catch (const ImageError& error) {
        EXPECT_STRNE(error.what(), "");
      }
    }
    // Half of a file is never enough.
    EXPECT_NE(Complaint({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2)}), "")
        << format.name;
  }
}

// K9. Any other exception, and any crash or hang, fails the test anyway.
TEST(ImageFile, AFlippedBitGivesAnErrorOrAnImage) {
  for (const ImageFormat& format : ImageFormats()) {
    Bytes bytes = format.encode(Gradient(9, 3), {}, {{"seed", "7"}});
    const Image whole = DecodeImage(bytes).image;
    int refused = 0;
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      SCOPED_TRACE(std::string(format.name) + " bit " + std::to_string(bit));
      const auto flip = static_cast<unsigned char>(1 << bit % 8);
      bytes[bit / 8] ^= flip;
      try {
        const Image image = DecodeImage(bytes).image;
        EXPECT_GE(image.Width(), 1);
        // Every chunk of a PNG has a checksum, so no damaged file passes for another image.
        EXPECT_TRUE(format.name != std::string("png") || image == whole);
      } catch (const ImageError&) {
        ++refused;
      }
      bytes[bit / 8] ^= flip;
    }
    EXPECT_GT(refused, 0) << format.name;
  }
}

TEST(ImageFile, ATruncatedFileReportsHowMuchIsPresent) {
  const auto half = [](const char* name) {
    Bytes bytes = Format(name).encode(Gradient(64, 512), {}, {});
    bytes.resize(bytes.size() / 2);
    return Complaint(bytes);
  };
  EXPECT_EQ(half("png").substr(0, 18), "PNG is truncated: ");
  EXPECT_NE(half("png").find(" of 512 rows are present"), std::string::npos);
  EXPECT_EQ(half("jpeg").substr(0, 19), "JPEG is truncated: ");
  EXPECT_NE(half("jpeg").find(" of 512 rows are present"), std::string::npos);
  EXPECT_EQ(half("ppm"), "PPM is truncated: the image takes 98304 bytes, but only 49145 are left");
}

// Web pages and cameras use arbitrary file names.
TEST(Extremes, K14_ContentDecidesTheKindAndNotTheName) {
  EXPECT_EQ(DecodeImage(Format("png").encode(Gradient(2, 2), {}, {})).format, FormatForName("a.png"));
  EXPECT_EQ(Complaint({1, 2, 3}).substr(0, 33), "unknown image format; supported: ");
  EXPECT_EQ(Complaint({}), "the image file is empty");
  for (const ImageFormat& format : ImageFormats()) {
    int recognized = 0;
    const Bytes bytes = format.encode(Gradient(2, 2), {}, {});
    for (const ImageFormat& other : ImageFormats()) recognized += other.recognizes(bytes);
    EXPECT_EQ(recognized, 1) << format.name;
  }
}

TEST(ImageFile, AnOutputNameFindsItsFormatInAnyLetterCase) {
  for (const ImageFormat& format : ImageFormats())
    for (const char* extension : format.extensions) {
      EXPECT_EQ(FormatForName(std::string("dir.d/a.b.") + extension), &format);
    }
  EXPECT_EQ(FormatForName("A.JPG"), &Format("jpeg"));
  EXPECT_EQ(FormatForName("A.Jpeg"), &Format("jpeg"));
  EXPECT_EQ(FormatForName("picture"), nullptr);
  EXPECT_EQ(FormatForName("dir.png/picture"), nullptr);
  EXPECT_EQ(FormatForName("a.png."), nullptr);
  EXPECT_EQ(FormatForName(""), nullptr);
}

// Only the 8 and 16 bit formats apply the curve: linear light written through it would be wrong everywhere.
TEST(ImageFile, OnlyTheByteKindsApplyTheSrgbCurve) {
  Image image(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) image.Set(x, y, {0.25, 0.25, 0.25});
  for (const ImageFormat& format : ImageFormats())
    for (const int bits : {8, 16}) {
      const Image decoded = DecodeImage(format.encode(image, {.srgb = true, .bits = bits}, {})).image;
      // 1.055 * 0.25^(1/2.4) - 0.055
      EXPECT_NEAR(decoded.At(8, 8).g, format.is_linear ? 0.25 : 0.537099, 0.003) << format.name;
    }
}

TEST(ImageFile, LinearKindsKeepWhatIsBrighterThanWhite) {
  Image image(9, 2);
  image.Set(3, 1, {1000, 0.5, 3e-4});
  for (const ImageFormat& format : ImageFormats()) {
    const Color c = DecodeImage(format.encode(image, {}, {})).image.At(3, 1);
    EXPECT_NEAR(c.r, format.is_linear ? 1000 : 1, 1000 / 256.0) << format.name;
    EXPECT_EQ(c.r > 1, format.is_linear) << format.name;
  }
}

// A wrong ray must spoil one pixel, not the file.
TEST(ImageFile, EveryFormatWritesNonFiniteValues) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  Image image(9, 2);
  image.Set(0, 0, {nan, nan, nan});
  image.Set(1, 0, {inf, inf, inf});
  image.Set(2, 0, {-inf, -1, -1e-30});
  for (const ImageFormat& format : ImageFormats())
    for (const bool srgb : {false, true}) {
      const Image decoded = DecodeImage(format.encode(image, {.srgb = srgb}, {})).image;
      const std::string name = format.name;
      if (name == "jpeg") continue;  // neighbors affect each other
      if (name == "pfm" || name == "exr") {
        EXPECT_TRUE(std::isnan(decoded.At(0, 0).g)) << name;
        EXPECT_EQ(decoded.At(1, 0).g, inf) << name;
        EXPECT_EQ(decoded.At(2, 0).g, -1) << name;
      } else {
        EXPECT_EQ(decoded.At(0, 0), (Color{0, 0, 0})) << name;
        EXPECT_GE(decoded.At(1, 0).g, 1) << name;
        EXPECT_EQ(decoded.At(2, 0), (Color{0, 0, 0})) << name;
      }
    }
}

// Each file states more than it contains, and the last ones more than 64 bits can count.
TEST(Extremes, K3_K5_AHeaderThatStatesTooMuchIsRefusedAtOnce) {
  const std::vector<Bytes> bombs{
      ToBytes("P6 65535 65535 255\n"),
      ToBytes("P6 16384 16384 255\n"),
      ToBytes("P3 16384 16384 255\n0 0 0"),
      ToBytes("P6 2147483647 2147483647 65535\n"),
      ToBytes("P6 99999999999999999999 1 255\n"),
      ToBytes("PF 16384 16384 -1\n"),
      ToBytes("PF 2147483647 2147483647 -1\n"),
      ToBytes("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 65535 +X 65535\n"),
      ToBytes("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n"),
      ToBytes("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 268435456\nabcdefgh"),
      // A bitmap of 2^31 - 1 by -2^31 pixels, and one of 16,384 by 16,384.
      ToBytes("BM") + Bytes(8) + Bytes{54, 0, 0, 0, 40, 0, 0, 0, 255, 255, 255, 127, 0, 0, 0, 128, 1, 0, 32, 0} +
          Bytes(24),
      ToBytes("BM") + Bytes(8) + Bytes{54, 0, 0, 0, 40, 0, 0, 0, 0, 64, 0, 0, 0, 64, 0, 0, 1, 0, 24, 0} + Bytes(24),
  };
  const auto start = std::chrono::steady_clock::now();
  for (const Bytes& bomb : bombs) {
    EXPECT_NE(Complaint(bomb), "") << std::string(bomb.begin(), bomb.end());
    EXPECT_NE(Complaint(bomb), "not enough memory for the image");
  }
  // Merely clearing the memory for any of these images would take longer than this.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(500));
}

TEST(ImageFile, ToByteRoundsToTheNearestAndClamps) {
  for (int i = 0; i <= 255; ++i) {
    EXPECT_EQ(ToByte(i / 255.0), i);
    EXPECT_EQ(ToByte((i + 0.499) / 255.0), i);
    EXPECT_EQ(ToByte((i - 0.499) / 255.0), i);
  }
  EXPECT_EQ(ToByte(-1), 0);
  EXPECT_EQ(ToByte(2), 255);
  EXPECT_EQ(ToByte(std::numeric_limits<double>::infinity()), 255);
  EXPECT_EQ(ToByte(-std::numeric_limits<double>::infinity()), 0);
  EXPECT_EQ(ToByte(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(ImageFile, ToShortRoundsToTheNearestAndClamps) {
  for (int i = 0; i <= 65535; ++i) ASSERT_EQ(ToShort((i + 0.49) / 65535.0), i);
  EXPECT_EQ(ToShort(-1), 0);
  EXPECT_EQ(ToShort(1e300), 65535);
  EXPECT_EQ(ToShort(std::numeric_limits<double>::quiet_NaN()), 0);
}

}  // namespace R2
