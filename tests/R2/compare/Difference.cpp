#include "R2/compare/Difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/R2/Filled.h"

namespace R2 {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Halves, quarters and eighths are exact in every step but the root.
TEST(Difference, AConstantOffsetIsItsOwnRmseAndBias) {
  const Difference d = Compare(Filled(5, 3, {0.5, 0.625, 0.75}), Filled(5, 3, {0.25, 0.375, 0.5}), Display::straight);
  EXPECT_DOUBLE_EQ(d.rmse, 0.25);
  EXPECT_DOUBLE_EQ(d.display_rmse, 255 * 0.25);
  EXPECT_EQ(d.bias, (Color{0.25, 0.25, 0.25}));
  EXPECT_DOUBLE_EQ(d.psnr, 20 * std::log10(4));
  EXPECT_EQ(d.pixels, 15);
}

TEST(Difference, EqualImagesHaveNoneAndAnInfinitePsnr) {
  const Image image = Filled(4, 4, {0.1, 7, -2});
  const Difference d = Compare(image, image, Display::srgb);
  EXPECT_EQ(d.rmse, 0);
  EXPECT_EQ(d.relative_mse, 0);
  EXPECT_EQ(d.largest.value, 0);
  EXPECT_EQ(d.psnr, infinity);
}

// Red: (0.5 - 0.25)^2 / (0.25^2 + 0.01); the others are equal.
TEST(Difference, TheRelativeErrorIsTheOneWorkedOutByHand) {
  const Difference d = Compare(Filled(1, 1, {0.5, 3, 0}), Filled(1, 1, {0.25, 3, 0}), Display::straight);
  EXPECT_DOUBLE_EQ(d.relative_mse, 0.0625 / 0.0725 / 3);
}

TEST(Difference, ValuesBeyondTheScreensRangeMakeNoDifference) {
  const Difference d = Compare(Filled(2, 2, {5, -1, 1}), Filled(2, 2, {3, -7, 1}), Display::straight);
  EXPECT_EQ(d.display_rmse, 0);
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt((4.0 + 36) / 3));
}

// sRGB encodes 0.5 as 0.7353569830524495.
TEST(Difference, TheSrgbCurveIsAppliedToDisplayedValuesOnly) {
  const Image half = Filled(2, 2, {0.5, 0.5, 0.5}), black = Filled(2, 2, {});
  EXPECT_NEAR(Compare(half, black, Display::srgb).display_rmse, 255 * 0.7353569830524495, 1e-9);
  EXPECT_DOUBLE_EQ(Compare(half, black, Display::srgb).rmse, 0.5);
  EXPECT_FLOAT_EQ(DisplayDifference(half, black, Display::srgb).values[3], 0.73535698f);
}

TEST(Difference, TheLargestIsFoundWithItsPixelAndChannel) {
  Image a = Filled(7, 5, {1, 1, 1});
  const Image b = a;
  a.Set(2, 1, {1, 1.5, 1});
  a.Set(6, 4, {1, 1, -3});
  const Difference d = Compare(a, b, Display::straight);
  EXPECT_EQ(d.largest.value, 4);
  EXPECT_EQ(d.largest.x, 6);
  EXPECT_EQ(d.largest.y, 4);
  EXPECT_EQ(d.largest.channel, 2);
}

// One bad pixel must neither spoil the means nor go unnoticed.
TEST(Difference, PixelsThatAreNotFiniteAreCountedAndExcluded) {
  Image a = Filled(4, 1, {0.5, 0.5, 0.5}), b = Filled(4, 1, {0.25, 0.25, 0.25});
  a.Set(0, 0, {0.5, nan, 0.5});
  b.Set(1, 0, {infinity, 0, 0});
  const Difference d = Compare(a, b, Display::straight);
  EXPECT_EQ(d.pixels_not_finite, 2);
  EXPECT_DOUBLE_EQ(d.rmse, 0.25);
  EXPECT_DOUBLE_EQ(d.largest.value, 0.25);
  EXPECT_DOUBLE_EQ(ProductMse(a, b, b), 0.0625);
  EXPECT_EQ(PixelsBeyond(a, b, 0.5), 2);
  EXPECT_EQ(PixelsBeyond(b, b, 0.5), 1) << "infinity exceeds every threshold, even next to another infinity";
}

TEST(Difference, NothingIsKnownWhenNoPixelIsFinite) {
  const Difference d = Compare(Filled(2, 2, {nan, 0, 0}), Filled(2, 2, {}), Display::straight);
  EXPECT_TRUE(std::isnan(d.rmse) && std::isnan(d.relative_mse) && std::isnan(d.psnr) && std::isnan(d.largest.value));
  EXPECT_EQ(d.pixels_not_finite, 4);
}

TEST(Difference, APixelFailsIfAnyChannelExceedsTheThreshold) {
  Image a = Filled(3, 1, {});
  a.Set(1, 0, {0, 0.25, 0});
  a.Set(2, 0, {0, 0, -0.5});
  const Image black = Filled(3, 1, {});
  EXPECT_EQ(PixelsBeyond(a, black, 0.5), 0);
  EXPECT_EQ(PixelsBeyond(a, black, 0.25), 1);
  EXPECT_EQ(PixelsBeyond(a, black, 0.125), 2);
}

// The image is wrong by 0.1 everywhere and has its own noise of 0.2, the references have noise of 0.3: the true squared
// error is 0.01 + 0.04 = 0.05, while one reference alone reports 0.05 + 0.09. With 120,000 channels the standard error
// of the product is below 5e-4.
TEST(Difference, TwoReferencesTakeTheirNoiseOutOfTheError) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto noisy = [&](double mean, double deviation) {
    Image image(200, 200);
    const auto value = [&] { return mean + deviation * normal(random); };
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 200; ++x) image.Set(x, y, {value(), value(), value()});
    return image;
  };
  const Image x = noisy(1.1, 0.2), r1 = noisy(1, 0.3), r2 = noisy(1, 0.3);
  const double plain = Compare(x, r1, Display::straight).rmse;
  EXPECT_NEAR(plain * plain, 0.14, 0.003);
  EXPECT_NEAR(ProductMse(x, r1, r2), 0.05, 0.002);
}

}  // namespace
}  // namespace R2
