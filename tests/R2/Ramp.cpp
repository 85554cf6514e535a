#include "R2/Ramp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace R2 {
namespace {

// A heat map printed in gray must still show the order of values.
TEST(Ramp, LuminanceIsTheNumber) {
  for (int i = 0; i <= 1000; ++i) EXPECT_NEAR(Luminance(RampColor(i / 1000.0)), i / 1000.0, 0.001) << i;
}

TEST(Ramp, IsColoredBetweenItsEnds) {
  for (const double t : {0.2, 0.4, 0.6, 0.8}) {
    const Color c = RampColor(t);
    EXPECT_GT(std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}), 0.15) << t;
  }
}

TEST(Ramp, NumbersOutsideTakeTheNearestEnd) {
  EXPECT_EQ(RampColor(0), (Color{0, 0, 0}));
  EXPECT_EQ(RampColor(-3), (Color{0, 0, 0}));
  EXPECT_EQ(RampColor(std::nan("")), (Color{0, 0, 0}));
  EXPECT_EQ(RampColor(1), (Color{1, 1, 1}));
  EXPECT_EQ(RampColor(std::numeric_limits<double>::infinity()), (Color{1, 1, 1}));
}

TEST(Ramp, AnImageKeepsTheRowsOfItsNumbers) {
  Plane numbers(2, 3);
  numbers.Row(2)[1] = 1;
  const Image image = RampImage(numbers);
  EXPECT_EQ(image.At(1, 2), (Color{1, 1, 1}));
  EXPECT_EQ(image.At(1, 0), (Color{0, 0, 0}));
  EXPECT_EQ(image.At(0, 2), (Color{0, 0, 0}));
}

}  // namespace
}  // namespace R2
