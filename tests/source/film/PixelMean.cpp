#include "source/film/PixelMean.h"

#include <gtest/gtest.h>

namespace {

TEST(PixelMean, IsTheMeanOfItsSamples) {
  ray::PixelMean mean;
  mean.Add({1, 2, 3});
  mean.Add({3, 4, 8});
  EXPECT_EQ(mean.Value(), (R2::Color{2, 3, 5.5}));
}

TEST(PixelMean, NeverPutsInfinityOrNaNIntoAPicture) {
  ray::PixelMean mean;
  mean.Add({1e300, -1e300, std::numeric_limits<double>::quiet_NaN()});
  const R2::Color value = mean.Value();
  EXPECT_TRUE(std::isfinite(static_cast<float>(value.r)));
  EXPECT_GT(value.r, 1e38);
  EXPECT_TRUE(std::isfinite(static_cast<float>(value.g)));
  EXPECT_EQ(value.b, 0);
}

}  // namespace
