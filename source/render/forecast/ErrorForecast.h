#pragma once

#include <optional>
#include <span>

#include "source/render/RenderSettings.h"
#include "source/render/RenderState.h"

namespace ray {

/// What the passes of a render tell of one that reaches a target.
struct ErrorForecast {
  double samples = 0;  // per pixel on average, of which the error would be at the target; infinity: it does not fall
  bool has_stalled = false;  // with sixteen times the samples, the squared error has not fallen by half
};

/// By how fast the upper end of the error's interval has fallen since there were a quarter of the samples; from one
/// pass alone, as it falls for independent samples: its square as 1 / samples. Nothing where none was measured.
std::optional<ErrorForecast> ForecastOf(std::span<const Pass> passes, const ErrorTarget& target);

}  // namespace ray
