#include "source/film/error/FQuantile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ray {
namespace {

TEST(FQuantile, EqualsThePublishedTable) {
  const struct {
    double p, m, n, f;
  } table[] = {{0.95, 1, 1, 161.4476}, {0.95, 2, 5, 5.7861},     {0.95, 5, 2, 19.2964}, {0.975, 10, 10, 3.7168},
               {0.99, 10, 20, 3.3682}, {0.95, 120, 120, 1.3519}, {0.975, 4, 30, 3.2499}};
  for (const auto& [p, m, n, f] : table) EXPECT_NEAR(FQuantile(p, m, n), f, 1e-4 * f) << p << ' ' << m << ' ' << n;
}

TEST(FQuantile, OfOneDegreeIsTheSquareOfStudentsT) {
  const struct {
    double p, degrees, t;  // exceeded on either side with 1 - p
  } table[] = {{0.95, 1, 12.7062},   {0.95, 2, 4.30265}, {0.95, 5, 2.57058},   {0.95, 30, 2.04227},
               {0.95, 1e6, 1.95997}, {0.99, 3, 5.84091}, {0.99, 120, 2.61742}, {0.8, 4, 1.53321}};
  for (const auto& [p, degrees, t] : table) EXPECT_NEAR(std::sqrt(FQuantile(p, 1, degrees)), t, 2e-5 * t) << degrees;
}

// F(2, 2) has the distribution f / (1 + f), and F(n, n) is below 1 as often as above.
TEST(FQuantile, MeetsItsClosedForms) {
  for (const double p : {0.01, 0.3, 0.5, 0.9, 0.999}) {
    EXPECT_NEAR(FQuantile(p, 2, 2), p / (1 - p), 1e-9 * p / (1 - p));
    for (const double n : {0.5, 3.0, 270.0, 1e5, 1e6})
      EXPECT_NEAR(FQuantile(p, n, n) * FQuantile(1 - p, n, n), 1, 1e-8) << p << ' ' << n;
  }
}

// The logarithm is nearly normal for many degrees of freedom, with variance 2 / m + 2 / n (Fisher, 1924).
TEST(FQuantile, IsNearFishersNormalForManyDegrees) {
  for (const double n : {1e4, 1e5, 1e6})
    EXPECT_NEAR(std::log(FQuantile(0.975, n, n)), 1.959964 * std::sqrt(4 / n), 2 / n) << n;
}

}  // namespace
}  // namespace ray
