#include <gtest/gtest.h>

#include <cmath>

#include "tests/R2/image_bytes.h"

namespace R2 {

namespace {

Bytes Header(const std::string& resolution) {
  return ToBytes("#?RADIANCE\n# a comment\nEXPOSURE=2\nFORMAT=32-bit_rle_rgbe\n\n" + resolution + "\n");
}

// Mantissa 128 of 256 with exponent 1 is one.
const Bytes white{128, 128, 128, 129}, red{128, 0, 0, 129}, blue{0, 0, 128, 129};

}  // namespace

TEST(Hdr, PlainPixelsAreReadFromTheTopLeft) {
  const DecodedImage decoded = DecodeImage(Header("-Y 2 +X 1") + red + blue);
  EXPECT_EQ(decoded.image.At(0, 1), (Color{1, 0, 0}));
  EXPECT_EQ(decoded.image.At(0, 0), (Color{0, 0, 1}));
  EXPECT_EQ(decoded.settings, (ImageSettings{{"EXPOSURE", "2"}}));
}

TEST(Hdr, OldRunsRepeatPixelsWithMultiByteCounts) {
  const Image image = DecodeImage(Header("-Y 1 +X 5") + red + Bytes{1, 1, 1, 3} + blue).image;
  EXPECT_EQ(image.At(3, 0), (Color{1, 0, 0}));
  EXPECT_EQ(image.At(4, 0), (Color{0, 0, 1}));
  // 2 + 256 * 1 repeats.
  const Image wide = DecodeImage(Header("-Y 1 +X 260") + red + Bytes{1, 1, 1, 2} + Bytes{1, 1, 1, 1} + blue).image;
  EXPECT_EQ(wide.At(258, 0), (Color{1, 0, 0}));
  EXPECT_EQ(wide.At(259, 0), (Color{0, 0, 1}));
}

TEST(Hdr, NewRunsHoldEachByteOfAllPixelsTogether) {
  const Bytes row = Bytes{2, 2, 0, 8} + Bytes{128 + 8, 128} + Bytes{8, 0, 0, 0, 0, 0, 0, 0, 64} +
                    Bytes{4, 0, 0, 0, 0, 128 + 4, 32} + Bytes{128 + 8, 129};
  const Image image = DecodeImage(Header("-Y 1 +X 8") + row).image;
  EXPECT_EQ(image.At(0, 0), (Color{1, 0, 0}));
  EXPECT_EQ(image.At(7, 0), (Color{1, 0.5, 0.25}));
}

TEST(Hdr, DamagedRunsAreRefused) {
  EXPECT_NE(Complaint(Header("-Y 1 +X 5") + Bytes{1, 1, 1, 5}), "");                          // nothing to repeat
  EXPECT_NE(Complaint(Header("-Y 1 +X 5") + red + Bytes{1, 1, 1, 5}), "");                    // one too many
  EXPECT_NE(Complaint(Header("-Y 1 +X 8") + Bytes{2, 2, 0, 9} + Bytes(100)), "");             // another width
  EXPECT_NE(Complaint(Header("-Y 1 +X 8") + Bytes{2, 2, 0, 8} + Bytes{0} + Bytes(100)), "");  // an empty stretch
  EXPECT_NE(Complaint(Header("-Y 1 +X 8") + Bytes{2, 2, 0, 8} + Bytes{128 + 9, 1} + Bytes(100)), "");
  EXPECT_NE(Complaint(Header("-Y 1 +X 8") + Bytes{2, 2, 0, 8} + Bytes{9} + Bytes(100)), "");
}

// Two by one pixels, red first: the first letter is the axis along which scan lines follow each other, and a sign
// states whether its coordinate increases, y upwards (Ward, Radiance File Formats).
TEST(Hdr, TheResolutionSaysWhereTheFirstPixelIs) {
  const struct {
    const char* resolution;
    int width, red_x, red_y;
  } cases[] = {{"-Y 1 +X 2", 2, 0, 0}, {"+Y 1 +X 2", 2, 0, 0}, {"-Y 1 -X 2", 2, 1, 0}, {"+Y 1 -X 2", 2, 1, 0},
               {"+X 1 -Y 2", 1, 0, 1}, {"-X 1 -Y 2", 1, 0, 1}, {"+X 1 +Y 2", 1, 0, 0}, {"-X 1 +Y 2", 1, 0, 0},
               {"+X 2 -Y 1", 2, 0, 0}, {"-X 2 -Y 1", 2, 1, 0}, {"+Y 2 +X 1", 1, 0, 0}, {"-Y 2 +X 1", 1, 0, 1}};
  for (const auto& c : cases) {
    const Bytes bytes = Header(c.resolution) + red + blue;
    const Image image = DecodeImage(bytes).image;
    ASSERT_EQ(image.Width(), c.width) << c.resolution;
    EXPECT_EQ(ReadImageSize(bytes).width, c.width) << c.resolution;
    EXPECT_EQ(image.At(c.red_x, c.red_y), (Color{1, 0, 0})) << c.resolution;
  }
}

TEST(Hdr, BrokenResolutionsAndOtherColorSpacesAreNamed) {
  EXPECT_NE(Complaint(ToBytes("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n") + white).find("32-bit_rle_rgbe"),
            std::string::npos);
  for (const char* bad : {"-Y 1 +X", "-Y +X 1", "-Y 1.5 +X 1", "-Y 1 +X 1 +X 1", "-Y 0 +X 1", "-Y -1 +X 1", "",
                          "-Y 1 +Y 1", "+X 1 -X 1", "Y 1 X 1", "-Z 1 +X 1"}) {
    EXPECT_EQ(Complaint(Header(bad) + white).substr(0, 4), "HDR ") << bad;
  }
  EXPECT_EQ(Complaint(Header("-Y 1 +X 1 ") + white), "");
}

// The last value of a name is kept as a setting, and all of them count.
TEST(Hdr, FactorsOfRepeatedLinesAreMultiplied) {
  const auto warnings = [](const std::string& lines) {
    return DecodeImage(ToBytes("#?RADIANCE\n" + lines + "\n-Y 1 +X 1\n") + white).warnings;
  };
  EXPECT_EQ(
      warnings("EXPOSURE=2\nEXPOSURE=4\n"),
      std::vector<std::string>{"HDR states that its values have been multiplied by an EXPOSURE of 8, which is not "
                               "undone; rayimg convert -exposure -3 undoes it"});
  EXPECT_TRUE(warnings("EXPOSURE=2\nEXPOSURE=0.5\n").empty());
  EXPECT_TRUE(warnings("EXPOSURE=bright\nEXPOSURE=0\nEXPOSURE=-1\nEXPOSURE=inf\nEXPOSURE=\n").empty());
  EXPECT_EQ(warnings("COLORCORR=2 1 1\nCOLORCORR=2 1\n").size(), 1u);
  EXPECT_EQ(warnings("PRIMARIES=1 0 0 1 0 0 0.333 0.333\n").size(), 1u);
  EXPECT_EQ(warnings("PRIMARIES=\n").size(), 1u);
}

// Run-length encoding is for flat stretches; noise must not grow by more than one count per 128 bytes.
TEST(Hdr, RunsMakeFlatImagesSmallAndNoiseHardlyLarger) {
  EXPECT_LT(Format("hdr").encode(Image(1000, 10), {}, {}).size(), 1000u);
  Image noise(1000, 10);
  unsigned state = 1;
  const auto random = [&] { return (state = state * 1664525u + 1013904223u) / 4294967296.0; };
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 1000; ++x) noise.Set(x, y, {random(), random(), random()});
  EXPECT_LT(Format("hdr").encode(noise, {}, {}).size(), 41500u);
}

TEST(Hdr, ValuesAreWithinHalfAStepOrSaturate) {
  const auto there_and_back = [](double value) {
    Image image(1, 1);
    image.Set(0, 0, {value, value, value});
    return DecodeImage(Format("hdr").encode(image, {}, {})).image.At(0, 0).g;
  };
  for (double value = 1e-37; value < 1e38; value *= 1.37) {
    EXPECT_NEAR(there_and_back(value), value, value / 256 * (1 + 1e-6)) << value;
  }
  EXPECT_EQ(there_and_back(0.999), 1);  // 255.7 of 256 carries over into the exponent
  EXPECT_EQ(there_and_back(3e38), std::ldexp(255.0, 119));
  EXPECT_EQ(there_and_back(1e-40), 0);
}

}  // namespace R2
