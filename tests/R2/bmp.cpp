#include <gtest/gtest.h>

#include "tests/R2/image_bytes.h"

namespace R2 {

namespace {

Bytes Little(std::uint32_t number) {
  return {static_cast<unsigned char>(number), static_cast<unsigned char>(number >> 8),
          static_cast<unsigned char>(number >> 16), static_cast<unsigned char>(number >> 24)};
}

/// Both headers, by hand; `offset` is where the pixels start.
Bytes Headers(std::uint32_t offset, std::uint32_t width, std::uint32_t height, unsigned char bits,
              std::uint32_t compression = 0, std::uint32_t colors = 0) {
  return ToBytes("BM") + Little(0) + Little(0) + Little(offset) + Little(40) + Little(width) + Little(height) +
         Bytes{1, 0, bits, 0} + Little(compression) + Little(0) + Little(0) + Little(0) + Little(colors) + Little(0);
}

// Blue, green, red; rows filled up to eight bytes.
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

TEST(Bmp, ThirtyTwoBitsHoldBlueGreenRedAndAByteThatIsDropped) {
  const Image image = DecodeImage(Headers(54, 1, 1, 32) + Bytes{51, 102, 255, 7}).image;
  EXPECT_EQ(ToByte(image.At(0, 0).r), 255);
  EXPECT_EQ(ToByte(image.At(0, 0).g), 102);
  EXPECT_EQ(ToByte(image.At(0, 0).b), 51);
}

TEST(Bmp, BitFieldsAreReadWhereTheySayTheUsual) {
  const Bytes pixel{51, 102, 255, 7};
  const Bytes usual = Little(0xff0000) + Little(0xff00) + Little(0xff);
  const Bytes swapped = Little(0xff) + Little(0xff00) + Little(0xff0000);
  EXPECT_EQ(ToByte(DecodeImage(Headers(66, 1, 1, 32, 3) + usual + pixel).image.At(0, 0).b), 51);
  EXPECT_NE(Complaint(Headers(66, 1, 1, 32, 3) + swapped + pixel), "");
}

TEST(Bmp, PalettesAreReadAndPixelsBeyondThemRefused) {
  const Bytes palette = Bytes{0, 0, 255, 0} + Bytes{255, 0, 0, 0};
  const Bytes headers = Headers(62, 2, 1, 8, 0, 2);
  const Image image = DecodeImage(headers + palette + Bytes{1, 0, 0, 0}).image;
  EXPECT_EQ(image.At(0, 0), (Color{0, 0, 1}));
  EXPECT_EQ(image.At(1, 0), (Color{1, 0, 0}));
  EXPECT_NE(Complaint(headers + palette + Bytes{2, 0, 0, 0}), "");
}

TEST(Bmp, WhatIsNotReadIsNamed) {
  EXPECT_EQ(Complaint(Headers(54, 1, 1, 8, 1) + Bytes(2000)), "BMP is compressed; only uncompressed ones are read");
  EXPECT_EQ(Complaint(Headers(54, 1, 1, 16) + Bytes(2000)), "BMP has 16 bits per pixel; 8, 24 and 32 are read");
  EXPECT_NE(Complaint(Headers(54, 0, 1, 24) + Bytes(2000)), "");
  EXPECT_NE(Complaint(Headers(0xffffffff, 1, 1, 24) + Bytes(2000)), "");
  EXPECT_NE(Complaint(Headers(54, 1, 0x80000000, 24) + Bytes(2000)), "");
}

}  // namespace R2
