#include <gtest/gtest.h>

#include "tests/R2/image_bytes.h"

namespace R2 {

TEST(Ppm, TextIsReadFromTheTopLeftWithCommentsAnywhere) {
  const DecodedImage decoded =
      DecodeImage(ToBytes("P3\n# a comment\n2 2 # another\r\n4\n4 0 0  0 4 0\n\t0 0 4 # pixels\n 1 2 3"));
  ASSERT_EQ(decoded.image.Width(), 2);
  ASSERT_EQ(decoded.image.Height(), 2);
  EXPECT_EQ(decoded.image.At(0, 1), (Color{1, 0, 0}));
  EXPECT_EQ(decoded.image.At(1, 1), (Color{0, 1, 0}));
  EXPECT_EQ(decoded.image.At(0, 0), (Color{0, 0, 1}));
  EXPECT_EQ(decoded.image.At(1, 0), (Color{0.25, 0.5, 0.75}));
}

TEST(Ppm, GrayIsReadAsTextAndAsBytes) {
  EXPECT_EQ(DecodeImage(ToBytes("P2 1 2 2 0 1")).image.At(0, 0), (Color{0.5, 0.5, 0.5}));
  const Image binary = DecodeImage(ToBytes("P5 1 2 255\n") + Bytes{0, 255}).image;
  EXPECT_EQ(binary.At(0, 0), (Color{1, 1, 1}));
  EXPECT_EQ(binary.At(0, 1), (Color{0, 0, 0}));
}

// In text, white space between bits is optional; rows of binary bits begin at whole bytes. One is black.
TEST(Ppm, BlackAndWhiteIsReadAsTextAndAsBits) {
  const Bytes images[] = {ToBytes("P1\n# bits\n9 2\n1 0 1 0 0 0 0 0 1\n000 000 110"),
                          ToBytes("P1 9 2 101000001000000110"), ToBytes("P4 9 2\n") + Bytes{0xa0, 0x80, 0x03, 0x00}};
  for (const Bytes& bytes : images) {
    const Image image = DecodeImage(bytes).image;
    EXPECT_EQ(image.At(0, 1), (Color{0, 0, 0}));
    EXPECT_EQ(image.At(1, 1), (Color{1, 1, 1}));
    EXPECT_EQ(image.At(8, 1), (Color{0, 0, 0}));
    EXPECT_EQ(image.At(7, 0), (Color{0, 0, 0}));
    EXPECT_EQ(image.At(8, 0), (Color{1, 1, 1}));
  }
  EXPECT_EQ(Complaint(ToBytes("P1 1 1 2")), "PPM is wrong: a pixel must be 0 or 1");
  EXPECT_NE(Complaint(ToBytes("P1 2 1 1")), "");
  EXPECT_NE(Complaint(ToBytes("P4 9 2\n") + Bytes{0xa0, 0x80, 0x03}), "");
}

// A pixel may be 10, which is also a line end: only the length of the file distinguishes them.
TEST(Ppm, TheFileLengthSeparatesHeaderBlanksFromPixels) {
  const Bytes line_and_51{'\n', 51};
  for (const char* header : {"P5 2 1 255\n", "P5 2 1 255\r", "P5 2 1 255\r\n", "P5 2 1 255 \n"}) {
    const DecodedImage decoded = DecodeImage(ToBytes(header) + line_and_51);
    EXPECT_EQ(ToByte(decoded.image.At(0, 0).r), 10) << header;
    EXPECT_EQ(ToByte(decoded.image.At(1, 0).r), 51) << header;
    EXPECT_TRUE(decoded.warnings.empty()) << header;
  }
}

// Nothing then indicates that the blank is surplus.
TEST(Ppm, OneBlankEndsTheHeaderOfAnOverlongFile) {
  const DecodedImage decoded = DecodeImage(ToBytes("P5 2 1 255 ") + Bytes{'\n', 51, 1, 2});
  EXPECT_EQ(ToByte(decoded.image.At(0, 0).r), 10);
  EXPECT_EQ(decoded.warnings, std::vector<std::string>{"PPM has 2 bytes after its image, which are ignored"});
}

TEST(Ppm, SurplusBytesAreReported) {
  const auto warnings = [](const std::string& text) { return DecodeImage(ToBytes(text)).warnings; };
  EXPECT_TRUE(warnings("P2 1 1 9 5\n\n # the end\n").empty());
  EXPECT_EQ(warnings("P2 1 1 9 5 6"), std::vector<std::string>{"PPM has 1 byte after its image, which is ignored"});
  EXPECT_EQ(warnings("P5 1 1 255\nabc"),
            std::vector<std::string>{"PPM has 2 bytes after its image, which are ignored"});
  EXPECT_EQ(warnings("P5 1 1 255\naP5 1 1 255\nb"),
            std::vector<std::string>{"PPM contains further images after the first, which are ignored"});
}

TEST(Ppm, ValuesAbove255AreTwoBytesTheHighOneFirst) {
  const Image image = DecodeImage(ToBytes("P6 1 1 65535\n") + Bytes{0xff, 0xff, 0x00, 0x01, 0x80, 0x00}).image;
  EXPECT_EQ(image.At(0, 0).r, 1);
  EXPECT_FLOAT_EQ(static_cast<float>(image.At(0, 0).g), 1 / 65535.0f);
  EXPECT_FLOAT_EQ(static_cast<float>(image.At(0, 0).b), 32768 / 65535.0f);
}

TEST(Ppm, IsWrittenByteForByteAsTheFormatSays) {
  Image image(1, 2);
  image.Set(0, 0, {1, 0, 0});
  image.Set(0, 1, {0, 0.5, 1});
  EXPECT_EQ(Format("ppm").encode(image, {}, {}), ToBytes("P6\n1 2\n255\n") + (Bytes{0, 128, 255, 255, 0, 0}));
}

// K6: a wrong number must not silently become another.
TEST(Ppm, InvalidOrOutOfRangeNumbersAreRefused) {
  for (const char* text :
       {"P3 1,5 1 255 0 0 0", "P3 0 1 255", "P3 -1 1 255 0 0 0", "P3 1 1 0 0 0 0", "P3 1 1 65536 0 0 0",
        "P3 1 1 255 0 0 256", "P3 1 1 255 0 0 -1", "P3 1 1 255 0 0 0x1", "P3 1 1 255 0 0 1e1", "P3 1 1 255 0 +1 0",
        "P3 1 1 255 0 0 nan", "P33 1 1 255 0 0 0", "P3 1 1 255 0 0"}) {
    EXPECT_EQ(Complaint(ToBytes(text)).substr(0, 4), "PPM ") << text;
  }
  EXPECT_NE(Complaint(ToBytes("P6 1 1 100\n") + Bytes{0, 101, 0}), "");
  EXPECT_NE(Complaint(ToBytes("P3 1 1 255 0 0 " + std::string(10000, '9'))), "");
}

}  // namespace R2
