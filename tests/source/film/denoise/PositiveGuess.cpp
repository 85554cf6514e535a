#include "source/film/denoise/DenoisedError.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ray {
namespace {

/// Computes the mean of a quantity by Simpson's rule over its density, exp(-x / expected) times the likelihood of the
/// measurement, scaled so that it neither overflows nor vanishes.
double IntegratedMean(double measured, double variance, double expected) {
  const auto log_density = [&](double x) { return -x / expected - (x - measured) * (x - measured) / (2 * variance); };
  const double peak = std::fmax(0, measured - variance / expected), most = log_density(peak);
  const double begin = std::fmax(0, peak - 20 * std::sqrt(variance)), end = peak + 20 * std::sqrt(variance);
  double mass = 0, moment = 0;
  constexpr int steps = 400000;
  for (int i = 0; i <= steps; ++i) {
    const double x = begin + (end - begin) * i / steps, weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
    const double density = weight * std::exp(log_density(x) - most);
    mass += density;
    moment += x * density;
  }
  return moment / mass;
}

TEST(PositiveGuess, IsTheMeanOfItsDistributionIntegrated) {
  for (const double noise : {0.01, 0.3, 1.0, 3.0, 30.0})
    for (const double measured : {-3.0, -1.0, 0.0, 0.5, 2.0, 40.0}) {
      const double expected = 0.7, mean = IntegratedMean(measured * noise, noise * noise, expected);
      EXPECT_NEAR(GuessPositive(measured * noise, noise * noise, expected).mean, mean, 1e-9 * mean)
          << noise << ' ' << measured;
    }
}

TEST(PositiveGuess, ItsSlopeIsTheDerivativeOfItsMean) {
  for (const double noise : {0.1, 1.0, 10.0})
    for (const double measured : {-4.0, -2.0, 0.0, 1.0, 20.0}) {
      constexpr double step = 1e-4;
      const auto mean_at = [&](double x) { return GuessPositive(x * noise, noise * noise, 1).mean; };
      const double growth = (mean_at(measured + step) - mean_at(measured - step)) / (2 * step * noise);
      EXPECT_NEAR(GuessPositive(measured * noise, noise * noise, 1).slope, growth, 1e-6)
          << noise << ' ' << measured;
    }
}

// Between the expected value, where noise hides everything, and the measured one, where there is hardly any.
TEST(PositiveGuess, GoesFromTheExpectedToTheMeasuredAsNoiseFalls) {
  EXPECT_NEAR(GuessPositive(3, 1e12, 0.5).mean, 0.5, 1e-6);
  EXPECT_NEAR(GuessPositive(3, 1e-12, 0.5).mean, 3, 1e-6);
  EXPECT_NEAR(GuessPositive(3, 1e12, 0.5).slope, 0, 1e-6);
  EXPECT_NEAR(GuessPositive(3, 1e-12, 0.5).slope, 1, 1e-6);
}

}  // namespace
}  // namespace ray
