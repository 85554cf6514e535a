#include "R2/Color.h"

#include <gtest/gtest.h>

namespace R2 {

// Values of the standard's table: half light is 188 of 255, byte 128 is 0.2159 light.
TEST(Color, TheSrgbCurveHasItsKnownValues) {
  EXPECT_EQ(EncodeSrgb(0.0), 0);
  EXPECT_NEAR(EncodeSrgb(1.0), 1, 1e-15);
  EXPECT_NEAR(EncodeSrgb(0.5), 0.7353569830524495, 1e-12);
  EXPECT_NEAR(EncodeSrgb(0.002), 0.02584, 1e-15);
  EXPECT_NEAR(DecodeSrgb(0.5), 0.21404114048223255, 1e-12);
  EXPECT_NEAR(DecodeSrgb(128 / 255.0), 0.2158605, 1e-7);
  EXPECT_NEAR(DecodeSrgb(0.04), 0.04 / 12.92, 1e-15);
}

// The two pieces of the published curve do not quite meet: a gap of 3e-8 in light.
TEST(Color, DecodingUndoesEncoding) {
  for (int i = -100; i <= 20000; ++i) {
    const double linear = i / 10000.0;
    EXPECT_NEAR(DecodeSrgb(EncodeSrgb(linear)), linear, 1e-7);
  }
}

TEST(Color, TheSrgbCurveNeverFalls) {
  for (int i = 1; i <= 100000; ++i) EXPECT_GT(EncodeSrgb(i / 100000.0), EncodeSrgb((i - 1) / 100000.0));
}

TEST(Color, WhiteHasLuminanceOne) { EXPECT_NEAR(Luminance({1, 1, 1}), 1, 1e-15); }

}  // namespace R2
