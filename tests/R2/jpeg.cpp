#include <gtest/gtest.h>

#include <cstdio>
// After cstdio, because jerror.h needs FILE.
#include <jpeglib.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "tests/R2/image_bytes.h"

namespace R2 {

namespace {

/// Makes a flat color of `components` channels, as another program would write it.
Bytes Flat(JDIMENSION size, int components, J_COLOR_SPACE space, bool is_progressive = false,
           J_COLOR_SPACE stored = JCS_UNKNOWN) {
  jpeg_error_mgr errors;
  jpeg_compress_struct codec;
  codec.err = jpeg_std_error(&errors);
  jpeg_create_compress(&codec);
  unsigned char* memory = nullptr;
  unsigned long length = 0;
  jpeg_mem_dest(&codec, &memory, &length);
  codec.image_width = codec.image_height = size;
  codec.input_components = components;
  codec.in_color_space = space;
  jpeg_set_defaults(&codec);
  if (stored != JCS_UNKNOWN) jpeg_set_colorspace(&codec, stored);
  if (is_progressive) jpeg_simple_progression(&codec);
  jpeg_start_compress(&codec, TRUE);
  std::vector<JSAMPLE> row(size * static_cast<std::size_t>(components), 102);
  JSAMPROW rows[1] = {row.data()};
  while (codec.next_scanline < size) jpeg_write_scanlines(&codec, rows, 1);
  jpeg_finish_compress(&codec);
  jpeg_destroy_compress(&codec);
  Bytes bytes(memory, memory + length);
  std::free(memory);
  return bytes;
}

/// Returns the position of the frame header's marker.
std::size_t Frame(const Bytes& bytes, unsigned char marker) {
  const unsigned char wanted[] = {0xff, marker};
  return static_cast<std::size_t>(std::search(bytes.begin(), bytes.end(), wanted, wanted + 2) - bytes.begin());
}

}  // namespace

TEST(Jpeg, GrayAndProgressiveImagesAreRead) {
  EXPECT_NEAR(DecodeImage(Flat(9, 1, JCS_GRAYSCALE)).image.At(4, 4).b, 0.4, 0.005);
  EXPECT_NEAR(DecodeImage(Flat(9, 3, JCS_RGB)).image.At(4, 4).b, 0.4, 0.005);
  EXPECT_NEAR(DecodeImage(Flat(9, 3, JCS_RGB, true)).image.At(4, 4).b, 0.4, 0.005);
}

// 102 of 255 of every ink transmit .4 of the light, twice: once for black.
TEST(Jpeg, InksAreReadAsAdobeHasThem) {
  for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK})
    EXPECT_NEAR(DecodeImage(Flat(9, 4, JCS_CMYK, false, stored)).image.At(4, 4).g, 0.4 * 0.4, 0.005) << stored;
  EXPECT_EQ(Complaint(Flat(9, 2, JCS_UNKNOWN)), "JPEG has 2 components; 1 (gray), 3 (color) and 4 (CMYK) are supported");
}

/// Makes an EXIF block with one entry, in the byte order of Intel or of Motorola.
Bytes Exif(unsigned char orientation, bool is_big, unsigned char type = 3) {
  const auto number = [&](std::uint32_t value, int count) {
    Bytes bytes;
    for (int i = 0; i < count; ++i)
      bytes.push_back(static_cast<unsigned char>(value >> 8 * (is_big ? count - 1 - i : i)));
    return bytes;
  };
  const Bytes value = is_big ? Bytes{0, orientation, 0, 0} : Bytes{orientation, 0, 0, 0};
  return ToBytes(is_big ? "MM" : "II") + number(42, 2) + number(8, 4) + number(1, 2) + number(0x112, 2) +
         number(type, 2) + number(1, 4) + value;
}

Bytes WithExif(const Bytes& jpeg, const Bytes& exif) {
  const Bytes start = ToBytes(std::string_view("Exif\0\0", 6));
  const auto length = static_cast<unsigned char>(2 + start.size() + exif.size());
  return Bytes(jpeg.begin(), jpeg.begin() + 2) + Bytes{0xff, 0xe1, 0, length} + start + exif +
         Bytes(jpeg.begin() + 2, jpeg.end());
}

// The position of the first pixel of the first row, by the table of Exif 2.3: row 0 and column 0 are top and left, top
// and right, bottom and right, bottom and left, and with rows and columns swapped left and top, right and top, and so
// on.
TEST(Jpeg, OrientationsOfExifTurnTheImage) {
  Image corner(16, 32);
  for (int y = 24; y < 32; ++y)
    for (int x = 0; x < 8; ++x) corner.Set(x, y, {1, 1, 1});
  const Bytes plain = Format("jpeg").encode(corner, {}, {});
  for (const bool is_big : {false, true}) {
    for (unsigned char orientation = 1; orientation <= 8; ++orientation) {
      const Bytes turned = WithExif(plain, Exif(orientation, is_big));
      const Image image = DecodeImage(turned).image;
      const bool is_wide = orientation >= 5;
      const bool is_right = std::array{0, 1, 1, 0, 0, 1, 1, 0}[orientation - 1u];
      const bool is_top = std::array{1, 1, 0, 0, 1, 1, 0, 0}[orientation - 1u];
      ASSERT_EQ(image.Width(), is_wide ? 32 : 16) << int{orientation};
      EXPECT_EQ(ReadImageSize(turned).width, image.Width());
      EXPECT_TRUE(DecodeImage(turned).settings.empty());
      EXPECT_GT(image.At(is_right ? image.Width() - 3 : 3, is_top ? image.Height() - 3 : 3).g, 0.9) << int{orientation};
      EXPECT_LT(image.At(is_right ? 3 : image.Width() - 3, is_top ? 3 : image.Height() - 3).g, 0.1) << int{orientation};
    }
  }
}

// No viewer rejects an image because of them.
TEST(Jpeg, BrokenBlocksOfExifTurnNothing) {
  const Bytes plain = Format("jpeg").encode(Gradient(16, 8), {}, {});
  const Image image = DecodeImage(plain).image;
  const Bytes good = Exif(6, false);
  for (std::size_t length = 0; length < good.size() - 4; ++length)
    EXPECT_EQ(DecodeImage(WithExif(plain, {good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length)})).image,
              image);
  for (const unsigned char orientation : Bytes{0, 9, 255})
    EXPECT_EQ(DecodeImage(WithExif(plain, Exif(orientation, true))).image, image);
  EXPECT_EQ(DecodeImage(WithExif(plain, Exif(6, false, 2))).image, image);  // letters
  for (const std::size_t byte : {0u, 2u, 4u, 7u, 10u, 12u}) {
    Bytes bad = good;
    bad[byte] ^= 0x80;
    EXPECT_EQ(DecodeImage(WithExif(plain, bad)).image, image) << byte;
  }
  EXPECT_EQ(DecodeImage(WithExif(WithExif(plain, Exif(6, false)), Exif(1, false))).image, image);  // the first counts
}

// Bits that flip on a disk: every viewer shows the rest, and here the user is warned.
TEST(Jpeg, DamageWithinThePixelsIsReportedOnce) {
  Bytes bytes = Format("jpeg").encode(Gradient(64, 64), {}, {});
  int warned = 0;
  for (std::size_t i = bytes.size() - 40; i < bytes.size() - 4; ++i) {
    bytes[i] ^= 0x14;
    try {
      const DecodedImage decoded = DecodeImage(bytes);
      EXPECT_LE(decoded.warnings.size(), 1u);
      if (!decoded.warnings.empty())
        warned += decoded.warnings[0].starts_with("JPEG is damaged, and parts of the image");
    } catch (const ImageError&) {
    }
    bytes[i] ^= 0x14;
  }
  EXPECT_GT(warned, 0);
}

// A stretch between two restart markers may stand for 65,535 blocks of pixels and take two bytes.
TEST(Jpeg, AFileTooSmallForItsPixelsIsRefused) {
  Bytes bytes = Flat(9, 1, JCS_GRAYSCALE);
  const std::size_t size = Frame(bytes, 0xc0) + 5;
  for (std::size_t i = 0; i < 4; ++i) bytes[size + i] = i % 2 ? 0 : 0x20;  // 8,192
  const std::size_t scan = Frame(bytes, 0xda);
  Bytes bomb = Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(scan)) +
               Bytes{0xff, 0xdd, 0, 4, 0xff, 0xff} +
               Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(scan), bytes.end() - 3);
  for (unsigned char i = 0; i < 32; ++i) bomb = bomb + Bytes{0xff, static_cast<unsigned char>(0xd0 + i % 8)};
  EXPECT_NE(Complaint(bomb + Bytes{0xff, 0xd9}).find("premature end of data segment"), std::string::npos);
}

// Halved color resolution causes colored fringes at rendered edges.
TEST(Jpeg, ColorIsNeverSubsampled) {
  for (const int quality : {1, 50, 95, 100}) {
    const Bytes bytes = Format("jpeg").encode(Gradient(16, 16), {.jpeg_quality = quality}, {});
    const std::size_t frame = Frame(bytes, 0xc0);
    ASSERT_LT(frame + 18, bytes.size());
    for (const std::size_t component : {0u, 1u, 2u}) EXPECT_EQ(bytes[frame + 11 + 3 * component], 0x11);
  }
}

TEST(Jpeg, HigherQualityMakesLargerFiles) {
  const auto size = [](int quality) {
    return Format("jpeg").encode(Gradient(64, 64), {.jpeg_quality = quality}, {}).size();
  };
  EXPECT_LT(size(10), size(90));
  EXPECT_LT(size(90), size(100));
}

// A block of one color takes 6, 4 and 4 bits for its three channels by the codes of the standard, Annex K.
TEST(Jpeg, AFlatImageIsSmallerThanWithStandardCodes) {
  constexpr int size = 512, blocks = size / 8 * (size / 8);
  EXPECT_LT(Format("jpeg").encode(Image(size, size), {.jpeg_quality = 90}, {}).size(), blocks * 14u / 8);
}

// As shown by `file` and image viewers.
TEST(Jpeg, SettingsAreReadableLinesInTheComment) {
  const Bytes bytes = Format("jpeg").encode(Image(1, 1), {}, {{"seed", "7"}, {"title", "a\nb"}});
  const std::string_view comment = "seed: 7\ntitle: a\\nb\n";
  EXPECT_NE(std::search(bytes.begin(), bytes.end(), comment.begin(), comment.end()), bytes.end());
}

TEST(Jpeg, SettingsLongerThanAMarkerSurvive) {
  for (const std::size_t length : {65524u, 65525u, 65526u, 65527u, 200000u}) {
    const ImageSettings settings{{"seed", std::string(length, 'x')}};
    EXPECT_EQ(DecodeImage(Format("jpeg").encode(Image(1, 1), {}, settings)).settings, settings) << length;
  }
}

TEST(Jpeg, ACommentOfAnotherProgramIsKept) {
  const Bytes plain = Format("jpeg").encode(Image(1, 1), {}, {});
  const Bytes comment = Bytes{0xff, 0xfe, 0, 9} + ToBytes("a photo");
  const Bytes bytes = Bytes(plain.begin(), plain.begin() + 2) + comment + Bytes(plain.begin() + 2, plain.end());
  EXPECT_EQ(DecodeImage(bytes).settings, (ImageSettings{{"comment", "a photo"}}));
}

// K3
TEST(Jpeg, AHeaderThatStatesTooMuchIsRefused) {
  Bytes bytes = Flat(9, 3, JCS_RGB);
  const std::size_t size = Frame(bytes, 0xc0) + 5;
  for (std::size_t i = 0; i < 4; ++i) bytes[size + i] = i % 2 ? 0xdc : 0xff;  // 65,500, the most the library takes
  EXPECT_EQ(Complaint(bytes), "JPEG states 65500 x 65500 pixels, above the limit of 268435456");
  for (std::size_t i = 0; i < 4; ++i) bytes[size + i] = 0xff;
  EXPECT_NE(Complaint(bytes), "");
  for (std::size_t i = 0; i < 4; ++i) bytes[size + i] = i % 2 ? 0 : 0x40;  // 16,384: under the limit, but not present
  EXPECT_NE(Complaint(bytes).find("0 of 16384 rows"), std::string::npos) << Complaint(bytes);
}

// The library would continue as long as scans come, each over the whole image.
TEST(Jpeg, ThousandsOfScansAreRefused) {
  const Bytes bytes = Flat(64, 3, JCS_RGB, true);
  const std::size_t last_scan = [&] {
    const unsigned char marker[] = {0xff, 0xda};
    return static_cast<std::size_t>(std::find_end(bytes.begin(), bytes.end(), marker, marker + 2) - bytes.begin());
  }();
  const Bytes scan(bytes.begin() + static_cast<std::ptrdiff_t>(last_scan), bytes.end() - 2);
  Bytes many(bytes.begin(), bytes.end() - 2);
  for (int i = 0; i < 3000; ++i) many = std::move(many) + scan;
  EXPECT_NE(Complaint(many + Bytes{0xff, 0xd9}), "");
}

TEST(Jpeg, AnImageTooLargeForTheFormatIsRefused) {
  EXPECT_THROW(Format("jpeg").encode(Image(65536, 1), {}, {}), ImageError);
}

}  // namespace R2
