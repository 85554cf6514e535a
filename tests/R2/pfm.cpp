#include <gtest/gtest.h>

#include <bit>

#include "tests/R2/image_bytes.h"

namespace R2 {

namespace {

// 1.0, -2.0 and 0.5, big-endian.
const Bytes one{0x3f, 0x80, 0, 0}, minus_two{0xc0, 0, 0, 0}, half{0x3f, 0, 0, 0};

}  // namespace

TEST(Pfm, APositiveScaleIsBigEndianAndRowsRunUpward) {
  const Image image = DecodeImage(ToBytes("PF\n1 2\n1.0\n") + one + minus_two + half + half + half + one).image;
  EXPECT_EQ(image.At(0, 0), (Color{1, -2, 0.5}));
  EXPECT_EQ(image.At(0, 1), (Color{0.5, 0.5, 1}));
}

TEST(Pfm, GrayIsReadInBothByteOrders) {
  EXPECT_EQ(DecodeImage(ToBytes("Pf 1 1 1\n") + minus_two).image.At(0, 0), (Color{-2, -2, -2}));
  EXPECT_EQ(DecodeImage(ToBytes("Pf 1 1 -1\n") + Bytes{0, 0, 0, 0xc0}).image.At(0, 0), (Color{-2, -2, -2}));
}

// A float may begin like white space: only the length of the file distinguishes them.
TEST(Pfm, TheFileLengthSeparatesHeaderBlanksFromPixels) {
  const Bytes blank_and_line{' ', '\n', 0x80, 0x3f};  // a float, little-endian
  const float as_pixel = std::bit_cast<float>(0x3f800a20u);
  EXPECT_EQ(DecodeImage(ToBytes("Pf 1 1 -1\n") + blank_and_line).image.At(0, 0).g, double{as_pixel});
  EXPECT_EQ(DecodeImage(ToBytes("Pf 1 1 -1\r") + blank_and_line).image.At(0, 0).g, double{as_pixel});
  EXPECT_EQ(DecodeImage(ToBytes("Pf 1 1 -1 \n") + blank_and_line).image.At(0, 0).g, double{as_pixel});
  EXPECT_EQ(DecodeImage(ToBytes("Pf 1 1 -1 \t\r\n") + blank_and_line).image.At(0, 0).g, double{as_pixel});
  for (const char* header : {"Pf 1 1 1\n", "Pf 1 1 1\r\n", "Pf\r\n1 1\r\n1\r\n", "Pf 1 1 1  \n"})
    EXPECT_TRUE(DecodeImage(ToBytes(header) + one).warnings.empty()) << header;
}

TEST(Pfm, SurplusBytesAreReported) {
  const DecodedImage decoded = DecodeImage(ToBytes("Pf 1 1 1\r\n") + one + Bytes{0, 0, 0});
  EXPECT_EQ(decoded.image.At(0, 0).g, 1);
  EXPECT_EQ(decoded.warnings, std::vector<std::string>{"PFM has 3 bytes after its image, which are ignored"});
}

TEST(Pfm, IsWrittenByteForByteAsTheFormatSays) {
  Image image(1, 1);
  image.Set(0, 0, {1, -2, 0.5});
  const Bytes pixels{0, 0, 0x80, 0x3f, 0, 0, 0, 0xc0, 0, 0, 0, 0x3f};
  EXPECT_EQ(Format("pfm").encode(image, {}, {}), ToBytes("PF\n1 1\n-1.0\n") + pixels);
}

TEST(Pfm, AScaleThatIsZeroOrNotANumberIsRefused) {
  for (const char* scale : {"0", "-0.0", "nan", "inf", "1,5", "1e999", "x", "1x"}) {
    EXPECT_NE(Complaint(ToBytes("Pf 1 1 " + std::string(scale) + "\n") + one), "") << scale;
  }
}

}  // namespace R2
