#include "R2/ToneCurve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace R2 {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const ToneCurve& Curve(const std::string& name) {
  for (const ToneCurve& curve : ToneCurves())
    if (name == curve.name) return curve;
  throw std::runtime_error("no curve " + name);
}

// Computed from the published constants.
TEST(ToneCurve, EveryCurveHasItsPublishedValues) {
  EXPECT_EQ(Curve("none").map(3.5), 3.5);
  EXPECT_EQ(Curve("reinhard").map(1), 0.5);
  EXPECT_EQ(Curve("reinhard").map(3), 0.75);
  EXPECT_NEAR(Curve("aces").map(1), 2.54 / 3.16, 1e-15);
  EXPECT_NEAR(Curve("aces").map(0.5), 0.6425 / 1.0425, 1e-15);
  // x = 2: (2 (0.3 + 0.05) + 0.004) / (2 (0.3 + 0.5) + 0.06) - 1/15; x = 11.2: 19.38 / 24.476 - 1/15.
  EXPECT_NEAR(Curve("filmic").map(1), (0.704 / 1.66 - 1 / 15.0) / (19.38 / 24.476 - 1 / 15.0), 1e-12);
  EXPECT_NEAR(Curve("filmic").map(5.6), 1, 1e-12) << "the white point";
}

TEST(ToneCurve, EveryCurveRisesFromBlackAndNeverFalls) {
  for (const ToneCurve& curve : ToneCurves()) {
    EXPECT_NEAR(curve.map(0), 0, 1e-15) << curve.name;
    for (double light = 1e-6, last = curve.map(0); light < 1e6; last = curve.map(light), light *= 1.1)
      EXPECT_GE(curve.map(light), last) << curve.name << " " << light;
  }
}

TEST(ToneCurve, EveryCurveButNoneStaysWithinBlackAndWhite) {
  for (const ToneCurve& curve : ToneCurves().subspan(1)) {
    for (const double light : {-infinity, -7.0, -1.0, 0.0, 1e300, infinity}) {
      EXPECT_GE(curve.map(light), -1e-15) << curve.name << " " << light;
      EXPECT_LE(curve.map(light), 1) << curve.name << " " << light;
    }
    EXPECT_NEAR(curve.map(infinity), 1, 1e-12) << curve.name;
    EXPECT_TRUE(std::isnan(curve.map(std::nan("")))) << curve.name;
  }
}

TEST(ToneCurve, ChannelsAreMappedOnTheirOwn) { EXPECT_EQ(Apply(Curve("reinhard"), {0, 1, 3}), (Color{0, 0.5, 0.75})); }

}  // namespace
}  // namespace R2
