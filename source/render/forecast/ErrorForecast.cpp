#include "source/render/forecast/ErrorForecast.h"

#include <algorithm>
#include <limits>

#include "R1/Elementary.h"

namespace ray {
namespace {

/// Returns the ratio of the squared worse end of an error's interval to the squared target.
double SquaredRatio(const ErrorEstimate& error, const ErrorTarget& target) {
  if (target.unit == ErrorUnit::decibel) return R1::Pow(10, (target.value - error.high) / 10);
  return error.high / target.value * (error.high / target.value);
}

/// Returns the last of these passes that had at most that many samples per pixel, and an error; null if none had.
const Pass* LastUpTo(double samples, std::span<const Pass> passes) {
  const auto found = std::find_if(passes.rbegin(), passes.rend(),
                                  [=](const Pass& pass) { return pass.error && pass.samples <= samples; });
  return found == passes.rend() ? nullptr : &*found;
}

}  // namespace

std::optional<ErrorForecast> ForecastOf(std::span<const Pass> passes, const ErrorTarget& target) {
  constexpr double fastest = 2;  // squared errors of the best sequences fall as 1 / samples^2 on smooth images
  // slower cannot be distinguished from not falling: 20 doublings would halve the square
  constexpr double slowest = 0.05;
  const Pass* now = LastUpTo(std::numeric_limits<double>::infinity(), passes);
  if (!now) return {};
  const double ratio = SquaredRatio(*now->error, target);
  if (!(ratio > 1)) return ErrorForecast{now->samples};
  ErrorForecast forecast;
  double fall = 1;
  if (const Pass* before = LastUpTo(now->samples / 4, passes))
    fall = R1::Log(SquaredRatio(*before->error, target) / ratio) / R1::Log(now->samples / before->samples);
  fall = std::min(fall, fastest);
  forecast.samples = fall > slowest ? now->samples * R1::Pow(ratio, 1 / fall) : std::numeric_limits<double>::infinity();
  const Pass* long_ago = LastUpTo(now->samples / 16, passes);
  forecast.has_stalled = long_ago && ratio > SquaredRatio(*long_ago->error, target) / 2;
  return forecast;
}

}  // namespace ray
