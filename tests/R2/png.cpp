#include <gtest/gtest.h>

#include <sys/resource.h>
#include <zlib.h>

#include <algorithm>

#include "tests/BlackPng.h"
#include "tests/R2/image_bytes.h"

namespace R2 {

namespace {

Bytes Big(std::uint32_t number) {
  return {static_cast<unsigned char>(number >> 24), static_cast<unsigned char>(number >> 16),
          static_cast<unsigned char>(number >> 8), static_cast<unsigned char>(number)};
}

/// The CRC of Annex D of the specification, bit by bit.
std::uint32_t Crc(const Bytes& bytes) {
  std::uint32_t crc = 0xffffffff;
  for (unsigned char byte : bytes) {
    crc ^= byte;
    for (int i = 0; i < 8; ++i) crc = crc & 1 ? 0xedb88320 ^ crc >> 1 : crc >> 1;
  }
  return ~crc;
}

Bytes Chunk(const std::string& name, const Bytes& data) {
  return Big(static_cast<std::uint32_t>(data.size())) + ToBytes(name) + data + Big(Crc(ToBytes(name) + data));
}

/// Makes a zlib stream with a single stored block (RFC 1950 and 1951).
Bytes Stored(const Bytes& data) {
  std::uint32_t a = 1, b = 0;
  for (unsigned char byte : data) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  const auto low = static_cast<unsigned char>(data.size()), high = static_cast<unsigned char>(data.size() >> 8);
  const auto not_low = static_cast<unsigned char>(~low), not_high = static_cast<unsigned char>(~high);
  return Bytes{0x78, 0x01, 0x01, low, high, not_low, not_high} + data + Big(b << 16 | a);
}

enum ColorType : unsigned char { gray = 0, rgb = 2, palette = 3, gray_alpha = 4, rgb_alpha = 6 };

Bytes Start(std::uint32_t columns, std::uint32_t rows, unsigned char depth, ColorType type, bool interlaced = false) {
  const Bytes signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  return signature + Chunk("IHDR", Big(columns) + Big(rows) + Bytes{depth, type, 0, 0, interlaced});
}

/// Returns the scan lines, each after its filter byte.
Bytes End(const Bytes& scan_lines) { return Chunk("IDAT", Stored(scan_lines)) + Chunk("IEND", {}); }

}  // namespace

TEST(Png, RowsAreReadFromTheTop) {
  const Image image = DecodeImage(Start(1, 2, 8, rgb) + End({0, 255, 0, 0, 0, 0, 0, 255})).image;
  EXPECT_EQ(image.At(0, 1), (Color{1, 0, 0}));
  EXPECT_EQ(image.At(0, 0), (Color{0, 0, 1}));
}

TEST(Png, GrayOfEveryDepthIsScaledToOne) {
  const struct {
    unsigned char depth;
    Bytes line;
    double first, second;
  } cases[] = {{1, {0, 0x40}, 0, 1},
               {2, {0, 0x60}, 1 / 3.0, 2 / 3.0},
               {4, {0, 0x3c}, 0.2, 0.8},
               {8, {0, 51, 204}, 0.2, 0.8},
               {16, {0, 0x33, 0x33, 0x00, 0x01}, 0.2, 1 / 65535.0}};
  for (const auto& c : cases) {
    const Image image = DecodeImage(Start(2, 1, c.depth, gray) + End(c.line)).image;
    EXPECT_NEAR(image.At(0, 0).r, c.first, 1e-7) << int{c.depth};
    EXPECT_NEAR(image.At(1, 0).b, c.second, 1e-7) << int{c.depth};
  }
}

TEST(Png, PaletteIndicesOfEveryDepthGiveTheirColors) {
  const Bytes colors = Chunk("PLTE", {0, 0, 0, 255, 0, 51});
  const Bytes lines[] = {{0, 0x40}, {0, 0x10}, {0, 0x01}, {0, 0, 1}};
  const unsigned char depths[] = {1, 2, 4, 8};
  for (std::size_t i = 0; i < 4; ++i) {
    for (const Bytes& transparency : {Bytes{}, Chunk("tRNS", {0, 0})}) {
      const Image image = DecodeImage(Start(2, 1, depths[i], palette) + colors + transparency + End(lines[i])).image;
      EXPECT_EQ(image.At(0, 0), (Color{0, 0, 0}));
      EXPECT_EQ(image.At(1, 0).r, 1);
      EXPECT_NEAR(image.At(1, 0).b, 0.2, 1e-7);
    }
  }
}

TEST(Png, AlphaIsDroppedAndTheColorBehindItKept) {
  EXPECT_EQ(DecodeImage(Start(1, 1, 8, rgb_alpha) + End({0, 255, 0, 255, 0})).image.At(0, 0), (Color{1, 0, 1}));
  EXPECT_EQ(DecodeImage(Start(1, 1, 8, gray_alpha) + End({0, 255, 0})).image.At(0, 0), (Color{1, 1, 1}));
  EXPECT_EQ(DecodeImage(Start(1, 1, 16, rgb_alpha) + End({0, 255, 255, 0, 0, 255, 255, 0, 0})).image.At(0, 0),
            (Color{1, 0, 1}));
  const Bytes transparent_gray = Chunk("tRNS", {0, 255});
  EXPECT_EQ(DecodeImage(Start(1, 1, 8, gray) + transparent_gray + End({0, 255})).image.At(0, 0), (Color{1, 1, 1}));
}

// An image that was cut out for the web has colors that were not meant to be seen.
TEST(Png, TransparentPixelsAreReportedAndOpaqueOnesAreNot) {
  const auto warnings = [](const Bytes& bytes) { return DecodeImage(bytes).warnings.size(); };
  EXPECT_EQ(warnings(Start(1, 1, 8, rgb_alpha) + End({0, 255, 0, 255, 254})), 1u);
  EXPECT_EQ(warnings(Start(1, 1, 8, rgb_alpha) + End({0, 255, 0, 255, 255})), 0u);
  EXPECT_EQ(warnings(Start(1, 1, 16, gray_alpha) + End({0, 255, 0, 255, 254})), 1u);
  EXPECT_EQ(warnings(Start(1, 1, 16, gray_alpha) + End({0, 255, 0, 255, 255})), 0u);
  const Bytes transparent_gray = Chunk("tRNS", {0, 255});
  EXPECT_EQ(warnings(Start(1, 1, 8, gray) + transparent_gray + End({0, 255})), 1u);
  EXPECT_EQ(warnings(Start(1, 1, 8, gray) + transparent_gray + End({0, 254})), 0u);
  EXPECT_EQ(
      warnings(Start(2, 2, 8, rgb_alpha, true) + End({0, 1, 2, 3, 255, 0, 1, 2, 3, 255, 0, 1, 2, 3, 9, 1, 2, 3, 9})),
      1u);
}

/// Makes an EXIF block for rows that are columns from the right.
const Bytes exif_6{'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 1, 0x12, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0};

TEST(Png, OrientationsOfExifTurnTheImageFromAnyPosition) {
  const Bytes start = Start(2, 1, 8, gray), pixels = Chunk("IDAT", Stored({0, 10, 20})), end = Chunk("IEND", {});
  const Bytes exif = Chunk("eXIf", exif_6);
  for (const Bytes& bytes : {start + exif + pixels + end, start + pixels + exif + end}) {
    const Image image = DecodeImage(bytes).image;
    ASSERT_EQ(image.Width(), 1);
    EXPECT_EQ(ReadImageSize(bytes).height, 2);
    EXPECT_EQ(ToByte(image.At(0, 1).g), 10);
    EXPECT_EQ(ToByte(image.At(0, 0).g), 20);
  }
  Bytes damaged = exif;
  damaged[damaged.size() - 5] ^= 1;  // which its checksum reveals
  EXPECT_EQ(DecodeImage(start + damaged + pixels + end).image.Width(), 2);
}

TEST(Png, AMissingEndIsReportedAndACutChunkRefused) {
  const Bytes whole = Start(1, 2, 8, rgb) + End({0, 255, 0, 0, 0, 0, 0, 255});
  const auto without = [&](std::ptrdiff_t bytes) { return Bytes(whole.begin(), whole.end() - bytes); };
  EXPECT_EQ(DecodeImage(without(12)).warnings,
            std::vector<std::string>{"PNG has no end chunk (IEND), but all its rows are present"});
  EXPECT_EQ(DecodeImage(without(12)).image, DecodeImage(whole).image);
  for (std::ptrdiff_t bytes = 1; bytes < std::ssize(whole) - 8; ++bytes) {
    if (bytes == 12) continue;
    EXPECT_EQ(Complaint(without(bytes)).substr(0, 17), "PNG is truncated:") << bytes;
    EXPECT_EQ(Complaint(without(bytes)).find("2 of 2 rows"), std::string::npos) << bytes;
  }
  EXPECT_EQ(DecodeImage(whole + Bytes{0}).warnings,
            std::vector<std::string>{"PNG has 1 byte after its image, which is ignored"});
}

// Adam7: of three by three pixels, pass 1 has (0,0), pass 5 (0,2) and (2,2), pass 4 (2,0), pass 6 (1,0) (1,2), 7 row 1.
TEST(Png, InterlacedImagesAreReadLikeOthers) {
  const Bytes passes{0, 10, 0, 12, 0, 30, 32, 0, 11, 0, 31, 0, 20, 21, 22};
  const Image interlaced = DecodeImage(Start(3, 3, 8, gray, true) + End(passes)).image;
  const Image plain = DecodeImage(Start(3, 3, 8, gray) + End({0, 10, 11, 12, 0, 20, 21, 22, 0, 30, 31, 32})).image;
  EXPECT_EQ(interlaced, plain);
  EXPECT_EQ(ToByte(plain.At(2, 0).g), 32);
}

// Viewers that honor gAMA would otherwise show the image differently from the same one in other formats.
TEST(Png, OnlySrgbImagesStateTheirCurve) {
  const auto has = [](const Bytes& bytes, std::string_view name) {
    return std::search(bytes.begin(), bytes.end(), name.begin(), name.end()) != bytes.end();
  };
  EXPECT_TRUE(has(Format("png").encode(Image(1, 1), {.srgb = true}, {}), "sRGB"));
  EXPECT_FALSE(has(Format("png").encode(Image(1, 1), {}, {}), "sRGB"));
  EXPECT_FALSE(has(Format("png").encode(Image(1, 1), {}, {}), "gAMA"));
}

TEST(Png, SixteenBitsAreKeptToTheLast) {
  Image image(2, 1);
  image.Set(0, 0, {1 / 65535.0, 12345 / 65535.0, 65534 / 65535.0});
  const Color c = DecodeImage(Format("png").encode(image, {.bits = 16}, {})).image.At(0, 0);
  EXPECT_EQ(ToShort(c.r), 1);
  EXPECT_EQ(ToShort(c.g), 12345);
  EXPECT_EQ(ToShort(c.b), 65534);
}

TEST(Png, TextChunksOfEveryKindAreRead) {
  const Bytes zero{0}, plain_text{0, 0};  // not compressed, by method 0
  const Bytes latin = Chunk("tEXt", ToBytes("Author") + zero + ToBytes("Zo\xeb"));
  const Bytes packed = Chunk("zTXt", ToBytes("Title") + Bytes{0, 0} + Stored(ToBytes("packed")));
  const Bytes utf8 = Chunk("iTXt", ToBytes("Note") + zero + plain_text + Bytes{0, 0} + ToBytes("\xe2\x98\x83"));
  const Bytes after = Chunk("tEXt", ToBytes("Late") + zero + ToBytes("behind the pixels"));
  const Bytes pixels = Chunk("IDAT", Stored({0, 1, 2, 3}));
  const Bytes bytes = Start(1, 1, 8, rgb) + latin + packed + utf8 + pixels + after + Chunk("IEND", {});
  const ImageSettings expected{
      {"Author", "Zo\xc3\xab"}, {"Title", "packed"}, {"Note", "\xe2\x98\x83"}, {"Late", "behind the pixels"}};
  EXPECT_EQ(DecodeImage(bytes).settings, expected);
}

// K3: the first is over the limit of pixels; the others are under it, but 100 bytes cannot contain that many.
TEST(Png, HeadersThatStateTooMuchAreRefused) {
  EXPECT_EQ(Complaint(Start(65535, 65535, 8, rgb) + End({0, 1, 2, 3})),
            "PNG states 65535 x 65535 pixels, above the limit of 268435456");
  EXPECT_NE(Complaint(Start(0x7fffffff, 0x7fffffff, 16, rgb_alpha) + End({0})), "");
  for (const bool interlaced : {false, true}) {
    for (const unsigned char depth : Bytes{1, 8, 16}) {
      const std::string complaint = Complaint(Start(16384, 16384, depth, gray, interlaced) + End({0, 1, 2, 3}));
      EXPECT_NE(complaint.find("cannot come out of"), std::string::npos) << complaint;
    }
  }
  EXPECT_NE(Complaint(Start(0, 1, 8, rgb) + End({0})), "");
}

// The header is read including the text after the pixels, which are skipped in compressed form: uncompressed they would
// be 3.2 GB.
TEST(Extremes, K4_PngMetadataIsReadWithoutDecompressingPixels) {
  const Bytes late = Chunk("tEXt", ToBytes("Late") + Bytes{0} + ToBytes("behind the pixels"));
  const Bytes bytes = ToBytes(BlackPng(16384, 16384, std::string(late.begin(), late.end())));
  EXPECT_LT(bytes.size(), 40'000u);
  const auto peak = [] {
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  const long before = peak();
  const ImageHeader header = ReadImageHeader(bytes);
  EXPECT_EQ(header.size.width, 16384);
  EXPECT_EQ(header.size.height, 16384);
  EXPECT_EQ(header.settings, (ImageSettings{{"Late", "behind the pixels"}}));
  EXPECT_LE(peak() - before, 16 * 1024);
}

TEST(Extremes, K4_PngTextBombsAreSkipped) {
  std::vector<unsigned char> text(std::size_t{4} << 20, 'x'), packed(std::size_t{1} << 20);
  uLongf length = packed.size();
  ASSERT_EQ(compress2(packed.data(), &length, text.data(), text.size(), 9), Z_OK);
  packed.resize(length);
  Bytes bytes = Start(1, 1, 8, rgb) + Chunk("tEXt", ToBytes("Author") + Bytes{0} + ToBytes("me"));
  for (int i = 0; i < 200; ++i)
    bytes = bytes + Chunk("zTXt", ToBytes("Bomb" + std::to_string(i)) + Bytes{0, 0} + packed);
  bytes = bytes + End({0, 1, 2, 3});
  std::size_t kept = 0;
  for (const ImageSettings& settings : {DecodeImage(bytes).settings, ReadImageHeader(bytes).settings}) {
    EXPECT_EQ(settings.at("Author"), "me");
    for (const auto& [key, value] : settings) kept += value.size();
  }
  EXPECT_LE(kept, std::size_t{2} << 20);
}

// The guard above must not reject well compressed images: a black one shrinks nearly 1032 times.
TEST(Png, ImagesCompressedToTheUtmostAreRead) {
  const Bytes bytes = Format("png").encode(Image(3000, 1000), {}, {});
  EXPECT_LT(bytes.size(), 10000u);
  EXPECT_EQ(DecodeImage(bytes).image, Image(3000, 1000));
}

TEST(Png, TooFewScanLinesAreNotFilledUp) {
  const std::string complaint = Complaint(Start(1, 3, 8, gray) + End({0, 1, 0, 2}));
  EXPECT_NE(complaint.find("2 of 3 rows"), std::string::npos) << complaint;
}

}  // namespace R2
