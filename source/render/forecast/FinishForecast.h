#pragma once

#include <functional>

#include "R2/Image.h"
#include "source/film/Film.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// How long an image of which nothing is known yet takes from its last sample to the finished file, in seconds: told by
/// encoding a small image, as `encode` does it.
///   accuracy   what is seen bears on it, so FinishForecast looks at the image itself
double SecondsToFinish(const RenderSettings& settings, const std::function<void(const R2::Image&)>& encode);

/// The budget of a render, told how long finishing and filtering take here; as it is where there is no time limit. Throws
/// DenoiserError.
Budget BudgetWithFinish(const RenderSettings& settings, const std::function<void(const R2::Image&)>& encode);

/// Forecasts how long an image takes from its last sample to the finished file, by composing and encoding parts of it,
/// since that depends on what is seen.
///   accuracy   measured in docs/accuracy.md
class FinishForecast {
 public:
  ///   seconds   the estimate until the first look
  ///   encode    encodes an image as it will be written; may be empty, and then looks tell nothing
  FinishForecast(double seconds, std::function<void(const R2::Image&)> encode)
      : encode_(std::move(encode)), seconds_(seconds) {}

  /// Looks at the image as it is; `quantization` says how its pixels will become bytes.
  void Look(const Film& film, R2::Quantization quantization);
  double Seconds() const { return seconds_; }

 private:
  std::function<void(const R2::Image&)> encode_;
  double seconds_;
  bool has_looked_ = false;
};

}  // namespace ray
