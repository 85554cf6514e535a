#include <gtest/gtest.h>

#include <cstdio>
// After cstdio, whose FILE it takes for granted.
#include <jpeglib.h>

#include <algorithm>
#include <cstdlib>

#include "tests/R2/image_bytes.h"

namespace R2 {

namespace {

/// One flat color of `components` channels, as another program would write it.
Bytes Flat(JDIMENSION size, int components, J_COLOR_SPACE space, bool is_progressive = false) {
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

/// Where the frame header's marker is.
std::size_t Frame(const Bytes& bytes, unsigned char marker) {
  const unsigned char wanted[] = {0xff, marker};
  return static_cast<std::size_t>(std::search(bytes.begin(), bytes.end(), wanted, wanted + 2) - bytes.begin());
}

}  // namespace

TEST(Jpeg, GrayAndProgressivePicturesAreRead) {
  EXPECT_NEAR(DecodeImage(Flat(9, 1, JCS_GRAYSCALE)).image.At(4, 4).b, 0.4, 0.005);
  EXPECT_NEAR(DecodeImage(Flat(9, 3, JCS_RGB)).image.At(4, 4).b, 0.4, 0.005);
  EXPECT_NEAR(DecodeImage(Flat(9, 3, JCS_RGB, true)).image.At(4, 4).b, 0.4, 0.005);
}

TEST(Jpeg, InksAreRefusedByName) {
  EXPECT_EQ(Complaint(Flat(9, 4, JCS_CMYK)),
            "JPEG has 4 components (CMYK?); only 1 (gray) and 3 (color) are supported");
}

// Half the color resolution puts colored fringes on rendered edges.
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
TEST(Jpeg, AnEvenPictureTakesFewerBytesThanTheCodesOfTheStandardWould) {
  constexpr int size = 512, blocks = size / 8 * (size / 8);
  EXPECT_LT(Format("jpeg").encode(Image(size, size), {.jpeg_quality = 90}, {}).size(), blocks * 14u / 8);
}

// What `file` and image viewers show.
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
TEST(Jpeg, AHeaderThatPromisesTooMuchIsRefused) {
  Bytes bytes = Flat(9, 3, JCS_RGB);
  const std::size_t size = Frame(bytes, 0xc0) + 5;
  for (std::size_t i = 0; i < 4; ++i) bytes[size + i] = i % 2 ? 0xdc : 0xff;  // 65,500, the most the library takes
  EXPECT_EQ(Complaint(bytes), "JPEG promises 65500 x 65500 pixels, more than the limit of 268435456");
  for (std::size_t i = 0; i < 4; ++i) bytes[size + i] = 0xff;
  EXPECT_NE(Complaint(bytes), "");
  for (std::size_t i = 0; i < 4; ++i) bytes[size + i] = i % 2 ? 0 : 0x40;  // 16,384: under the limit, but not there
  EXPECT_NE(Complaint(bytes).find("0 of 16384 rows"), std::string::npos) << Complaint(bytes);
}

// The library would go on for as long as scans come, each over the whole picture.
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

TEST(Jpeg, APictureTooLargeForTheFormatIsRefusedAndNotCut) {
  EXPECT_THROW(Format("jpeg").encode(Image(65536, 1), {}, {}), ImageError);
}

}  // namespace R2
