#pragma once

#include <optional>
#include <span>

#include "source/render/RenderSettings.h"
#include "source/render/RenderState.h"

namespace ray {

/// A prediction, from the passes of a render, of when its error reaches a target.
struct ErrorForecast {
  // per pixel on average at which the error would be at the target; infinity: it does not fall
  double samples = 0;
  // with sixteen times the samples, the squared error has not fallen by half
  bool has_stalled = false;
};

/// Predicts from the fall of the upper end of the error's interval since a quarter of the samples. From a single pass,
/// assumes that the error falls as for independent samples: its square as 1 / samples. Returns std::nullopt if none was
/// measured.
std::optional<ErrorForecast> ForecastOf(std::span<const Pass> passes, const ErrorTarget& target);

}  // namespace ray
