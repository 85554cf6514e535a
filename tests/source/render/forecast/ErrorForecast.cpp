#include "source/render/forecast/ErrorForecast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ray {
namespace {

constexpr ErrorTarget one{1, ErrorUnit::linear};

Pass PassOf(double samples, double error) {
  Pass pass;
  pass.samples = samples;
  pass.error.emplace();
  pass.error->high = error;
  return pass;
}

TEST(Forecast, NothingIsPredictedBeforeAnErrorWasMeasured) {
  EXPECT_FALSE(ForecastOf({}, one));
  EXPECT_FALSE(ForecastOf(std::vector<Pass>(1), one));
}

TEST(Forecast, ASinglePassIsExtrapolatedAsIndependentSamples) {
  EXPECT_NEAR(ForecastOf(std::vector{PassOf(16, 3)}, one)->samples, 16 * 9, 1e-9);
}

TEST(Forecast, AnErrorThatFallsFasterNeedsFewerSamples) {
  const std::vector passes{PassOf(16, 8), PassOf(32, 4), PassOf(64, 2)};  // error ~ 1 / samples
  EXPECT_NEAR(ForecastOf(passes, one)->samples, 128, 1e-9);
}

TEST(Forecast, AtTheTargetNothingMoreIsNeeded) {
  EXPECT_EQ(ForecastOf(std::vector{PassOf(16, 3), PassOf(64, 0.99)}, one)->samples, 64);
}

TEST(Forecast, AnErrorThatDoesNotFallNeverReachesItsTarget) {
  const std::vector passes{PassOf(16, 3), PassOf(64, 3)};
  EXPECT_EQ(ForecastOf(passes, one)->samples, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(ForecastOf(passes, one)->has_stalled) << "only four times the samples";
}

TEST(Forecast, StalledMeansNotHalvedBySixteenfoldSamples) {
  const auto has_stalled = [](double last) {
    return ForecastOf(std::vector{PassOf(16, 3), PassOf(64, 9), PassOf(256, last)}, one)->has_stalled;
  };
  EXPECT_TRUE(has_stalled(3));
  EXPECT_TRUE(has_stalled(3 / std::sqrt(1.99)));
  EXPECT_FALSE(has_stalled(3 / std::sqrt(2.01)));
}

TEST(Forecast, DecibelsRiseTowardsTheirTarget) {
  Pass pass = PassOf(16, 30);
  const ErrorTarget target{40, ErrorUnit::decibel};
  EXPECT_NEAR(ForecastOf(std::vector{pass}, target)->samples, 160, 1e-9) << "a tenth of the square";
  pass.error->high = 41;
  EXPECT_EQ(ForecastOf(std::vector{pass}, target)->samples, 16);
}

}  // namespace
}  // namespace ray
