#include "source/integrate/shading/Refract.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

constexpr R3::Vector up{0, 1, 0};

R3::Vector Falling(double angle) { return {std::sin(angle), -std::cos(angle), 0}; }

TEST(Refract, ObeysSnellsLaw) {
  for (const double eta : {0.5, 1 / 1.5, 1.0, 1.2})
    for (double angle = 0; angle < 0.9; angle += 0.1) {
      const auto bent = ray::Refract(Falling(angle), up, eta);
      ASSERT_TRUE(bent);
      EXPECT_NEAR(bent->x, eta * std::sin(angle), 1e-15);
      EXPECT_NEAR(Length(*bent), 1, 1e-15);
      EXPECT_LT(bent->y, 0);
    }
}

TEST(Extremes, F3_ExtremeIndicesGiveFiniteDirectionsOrTotalReflection) {
  for (const double eta : {1e-6, 1e6})
    for (const double angle : {0.0, 1e-12, 1e-7, 0.5, 1.5}) {
      const auto bent = ray::Refract(Falling(angle), up, eta);
      EXPECT_TRUE(!bent || eta * std::sin(angle) <= 1.001);
      EXPECT_NEAR(bent ? Length(*bent) : 1, 1, 1e-15);
    }
}

TEST(Extremes, F4_RefractionStopsForGoodAtTheCriticalAngle) {
  // sin = 1 / eta is the critical sine. Nothing may be NaN, and once rays stop leaving they must not leave again.
  const double eta = 1.5;
  double sine = 1 / eta;
  for (int i = 0; i < 8; ++i) sine = std::nextafter(sine, 0);
  bool total = false;
  for (int i = -8; i <= 8; ++i, sine = std::nextafter(sine, 1)) {
    const R3::Vector d{sine, -std::sqrt((1 - sine) * (1 + sine)), 0};
    const auto bent = ray::Refract(d, up, eta);
    if (!bent)
      total = true;
    else {
      EXPECT_FALSE(total) << "refraction after total reflection at " << i;
      EXPECT_NEAR(Length(*bent), 1, 1e-15);
      EXPECT_LE(bent->y, 0);
    }
  }
  EXPECT_TRUE(total);
}

TEST(Reflect, KeepsTheAngleAndLeavesOnTheSameSide) {
  const R3::Vector d = Falling(0.7), r = ray::Reflect(d, up);
  EXPECT_DOUBLE_EQ(r.x, d.x);
  EXPECT_DOUBLE_EQ(r.y, -d.y);
}

}  // namespace
