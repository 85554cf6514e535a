#pragma once

#include <functional>

#include "R2/Image.h"
#include "source/film/Film.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// Estimates the time from an image's last sample to the finished file, in seconds, if nothing is known of the image
/// yet, by encoding a small image with `encode`.
///   accuracy   the time depends on the visible scene, so FinishForecast examines the image itself
double SecondsToFinish(const RenderSettings& settings, const std::function<void(const R2::Image&)>& encode);

/// Returns the budget of a render, with the times of finishing and filtering on this machine; unchanged without a time
/// limit. Throws DenoiserError.
Budget BudgetWithFinish(const RenderSettings& settings, const std::function<void(const R2::Image&)>& encode);

/// Predicts the time from an image's last sample to the finished file. It composes and encodes parts of the image,
/// since the time depends on the visible scene.
///   accuracy   measured in docs/notes/accuracy.md
class FinishForecast {
 public:
  /// Creates a forecast.
  ///   seconds   the estimate until the first look
  ///   encode    encodes an image as it will be written; may be empty, and then looks have no effect
  FinishForecast(double seconds, std::function<void(const R2::Image&)> encode)
      : encode_(std::move(encode)), seconds_(seconds) {}

  /// Examines the current image; `quantization` says how its pixels will become bytes.
  void Look(const Film& film, R2::Quantization quantization);
  double Seconds() const { return seconds_; }

 private:
  std::function<void(const R2::Image&)> encode_;
  double seconds_;
  bool has_looked_ = false;
};

}  // namespace ray
