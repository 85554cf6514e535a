#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "source/render/RenderState.h"
#include "source/render/Schedule.h"
#include "source/render/forecast/ErrorForecast.h"

namespace ray {

/// The measure in which the settings ask for errors.
ErrorMeasure MeasureFor(const RenderSettings& settings);

/// The passes of a render that are over, and the errors that were measured after them.
class PassHistory {
 public:
  /// A look at the denoised image: its error, or none if that was not measured.
  struct Look {
    std::optional<MeasuredError> error;
    bool was_stopped = false;  // with the render
  };
  /// `noisy`: the error before the filters.
  using LookAtDenoised = std::function<Look(const MeasuredError& noisy, const UnseenLight& unseen)>;

  /// `is_watched`: someone sees the image after each pass. `look`: where the error of the denoised image decides, else
  /// empty; then passes have that error. The first two must outlive this.
  PassHistory(const RenderSettings& settings, const Film& film, bool is_watched, const ErrorMeasure& measure,
              LookAtDenoised look = {});

  const std::vector<Pass>& Passes() const { return passes_; }
  /// Errors of blocks after the last pass that was measured.
  const BlockErrors& Differences() const { return differences_; }

  void Resume(std::vector<Pass> passes, BlockErrors differences);

  /// Notes that the pass is over which the schedule chose, and measures its error where something depends on it. A pass
  /// whose look at the denoised image was stopped is not over.
  ///   samples   per pixel, on average
  ///   seconds   since the render began
  std::optional<MeasuredError> Note(const Schedule& schedule, double samples, double seconds,
                                    const UnseenLight& unseen);
  /// Forecasts when the error asked for is reached; nothing where none is asked for or none was measured.
  std::optional<ErrorForecast> Forecast() const;

  /// Ends the history, and returns the error of the film, not denoised: that of the last pass, unless samples
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
  std::optional<ErrorEstimate>
      noisy_;  // the error of the film after the last pass, where passes have that of the denoised
};

}  // namespace ray
