#include "source/film/Filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include <numbers>
#include "tests/source/film/FilterKinds.h"

namespace ray {
namespace {

/// The published formulas in another form: Mitchell and Netravali's by its factored halves for B = C = 1/3, sinc as a
/// product of cosines (Viete).
double Published(FilterKind kind, double distance) {
  const double x = std::abs(distance);
  const auto sinc = [](double t) {
    double product = 1;
    for (int k = 1; k < 40; ++k) product *= std::cos(std::ldexp(std::numbers::pi * t, -k));
    return product;
  };
  switch (kind) {
    case FilterKind::box:
      return x < 0.5 ? 1 : 0;
    case FilterKind::gaussian:
      return x < 2 ? std::exp(-2 * x * x) - std::exp(-8.0) : 0;
    case FilterKind::mitchell:
      if (x < 1) return (21 * x * x * x - 36 * x * x + 16) / 18;
      return x < 2 ? (-7 * x * x * x + 36 * x * x - 60 * x + 32) / 18 : 0;
    case FilterKind::lanczos:
      return x < 3 ? sinc(x) * sinc(x / 3) : 0;
  }
  return 0;
}

TEST(Filter, TheTableIsWithinAMillionthOfThePublishedFormula) {
  for (const FilterKind kind : kinds) {
    const Filter filter(kind);
    for (double x = -4; x <= 4; x += 0x1p-10 * 0.37) {
      ASSERT_NEAR(filter(x), Published(kind, x), 1e-6) << NameOf(kind) << ' ' << x;
      ASSERT_NEAR(FilterFormula(kind, x), Published(kind, x), 1e-14) << NameOf(kind) << ' ' << x;
    }
  }
}

TEST(Filter, IsEvenAndEndsAtItsRadius) {
  for (const FilterKind kind : kinds) {
    const Filter filter(kind);
    for (double x = 0; x < 4; x += 0.01) EXPECT_EQ(filter(x), filter(-x)) << NameOf(kind);
    for (const double beyond : {filter.Radius(), std::nextafter(filter.Radius(), 9.0), 1e300}) {
      EXPECT_EQ(filter(beyond), 0) << NameOf(kind);
      EXPECT_EQ(filter(-beyond), 0) << NameOf(kind);
    }
    EXPECT_NE(filter(std::nextafter(filter.Radius(), 0.0)), 0) << NameOf(kind);
    EXPECT_EQ(filter(std::nan("")), 0) << NameOf(kind);
  }
}

TEST(Filter, ReachesNoPixelBeyondItsApron) {
  for (const FilterKind kind : kinds) {
    const Filter filter(kind);
    const double farthest_in_pixel = filter.Apron() + 0.5;  // from the middle of the first pixel it does not reach
    if (!filter.IsBox()) {
      EXPECT_EQ(filter(farthest_in_pixel + 0.5), 0) << NameOf(kind);
    }
    EXPECT_EQ(filter.Apron(), static_cast<int>(filter.Radius())) << NameOf(kind);
  }
}

/// Returns the largest relative deviation of a sample's total weight over all pixels, at its best and worst place, from
/// the mean over places.
double Unevenness(FilterKind kind) {
  const Filter filter(kind);
  double least = HUGE_VAL, most = 0, sum = 0;
  constexpr int places = 1000;
  for (int i = 0; i < places; ++i) {
    double all = 0;
    for (int pixel = -5; pixel <= 5; ++pixel) all += filter((i + 0.5) / places - (pixel + 0.5));
    least = std::min(least, all), most = std::max(most, all), sum += all / places;
  }
  return (most - least) / sum;
}

// The contribution of a sample to the image should not depend on its place in the pixel: that would be a pattern.
TEST(Filter, SamplesCountAlmostEquallyAnywhereInAPixel) {
  EXPECT_EQ(Unevenness(FilterKind::box), 0);
  EXPECT_LT(Unevenness(FilterKind::mitchell), 1e-6);  // exactly 0 by the formula, whose weights sum to 1 for any B, C
  EXPECT_LT(Unevenness(FilterKind::gaussian), 0.03);  // 4 exp(-pi^2 / 2), by Poisson's sum
  EXPECT_LT(Unevenness(FilterKind::lanczos), 0.03);
  EXPECT_GT(Unevenness(FilterKind::lanczos), 1e-3) << "a filter whose weights are not normalized is uneven";
}

}  // namespace
}  // namespace ray
