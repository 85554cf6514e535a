#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "source/render/RenderState.h"
#include "source/render/Schedule.h"
#include "source/render/forecast/ErrorForecast.h"

namespace ray {

/// Returns the measure of errors that the settings select.
ErrorMeasure MeasureFor(const RenderSettings& settings);

/// The completed passes of a render, and the errors that were measured after them.
class PassHistory {
 public:
  /// The result of a look at the denoised image: its error, unless that was not measured.
  struct Look {
    std::optional<MeasuredError> error;
    bool was_stopped = false;  // the render was stopped meanwhile
  };
  /// A function that looks at the denoised image. `noisy`: the error before the filters.
  using LookAtDenoised = std::function<Look(const MeasuredError& noisy, const UnseenLight& unseen)>;

  /// `is_watched`: the image is shown after each pass. `look`: empty unless the error of the denoised image decides;
  /// then passes have that error. The first two arguments must outlive this.
  PassHistory(const RenderSettings& settings, const Film& film, bool is_watched, const ErrorMeasure& measure,
              LookAtDenoised look = {});

  const std::vector<Pass>& Passes() const { return passes_; }
  /// The errors of blocks after the last measured pass.
  const BlockErrors& Differences() const { return differences_; }

  void Resume(std::vector<Pass> passes, BlockErrors differences);

  /// Notes the completed pass that the schedule chose, and measures its error if something depends on it. A pass whose
  /// look at the denoised image was stopped is not complete.
  ///   samples   per pixel, on average
  ///   seconds   since the render began
  std::optional<MeasuredError> Note(const Schedule& schedule, double samples, double seconds,
                                    const UnseenLight& unseen);
  /// Returns the error of the film after the last pass, if passes have that of the denoised image.
  const std::optional<MeasuredError>& Noisy() const { return noisy_; }
  /// Predicts when the error target will be reached; std::nullopt without a target or a measurement.
  std::optional<ErrorForecast> Forecast() const;

  /// Ends the history, and returns the error of the film without denoising: that of the last pass, unless samples
  /// `have_come` since.
  std::optional<ErrorEstimate> Finish(bool have_come, const UnseenLight& unseen);

 private:
  std::optional<MeasuredError> Measure(const UnseenLight& unseen) const;

  const RenderSettings& settings_;
  const Film& film_;
  const ErrorMeasure measure_;
  const bool are_counted_;
  const LookAtDenoised look_at_denoised_;
  std::vector<Pass> passes_;
  BlockErrors differences_;
  std::optional<MeasuredError> noisy_;  // see Noisy
};

}  // namespace ray
