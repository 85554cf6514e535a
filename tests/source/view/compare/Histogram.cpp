#include "source/view/compare/Histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace ray {
namespace {

/// A ramp from 0 to 1 in red, the same up to 2 in green, and one value in blue.
R2::Image Ramp(int width) {
  R2::Image image(width, 1);
  for (int x = 0; x < width; ++x) {
    const double value = (x + 0.5) / width;
    image.Set(x, 0, {value, 2 * value, 0.25});
  }
  return image;
}

TEST(Histogram, OfARampIsEvenAndCountsWhatIsClipped) {
  constexpr int per_bin = 10, width = per_bin * static_cast<int>(Histogram::bins);
  const Histogram histogram = HistogramOf(Ramp(width), 1);
  for (const std::int64_t count : histogram.counts[0]) EXPECT_EQ(count, per_bin);
  EXPECT_EQ(histogram.counts[2][Histogram::bins / 4], width);
  for (const auto& channel : histogram.counts)
    EXPECT_EQ(std::accumulate(channel.begin(), channel.end(), std::int64_t{0}), width);
  EXPECT_EQ(histogram.above, width / 2);
  EXPECT_NEAR(histogram.mean.r, 0.5, 1e-12);
  EXPECT_NEAR(histogram.brightest, 2, 2.0 / width);
}

TEST(Histogram, FollowsTheExposure) {
  const Histogram histogram = HistogramOf(Ramp(640), 0.5);
  EXPECT_EQ(histogram.above, 0);
  EXPECT_EQ(histogram.counts[2][Histogram::bins / 8], 640);
}

TEST(Histogram, CountsNansApartFromColors) {
  R2::Image image(3, 1);
  image.Set(0, 0, {NAN, 0, 0});
  image.Set(1, 0, {0, INFINITY, 0});
  image.Set(2, 0, {-1, 0.5, 0.5});
  const Histogram histogram = HistogramOf(image, 1);
  EXPECT_EQ(histogram.not_finite, 2);
  EXPECT_EQ(histogram.below, 1);
  EXPECT_EQ(histogram.mean, (R2::Color{-1, 0.5, 0.5}));
}

}  // namespace
}  // namespace ray
