#include "source/render/PassHistory.h"

#include <utility>

namespace ray {

ErrorMeasure MeasureFor(const RenderSettings& settings) {
  return {settings.budget.error ? settings.budget.error->unit : ErrorUnit::display, settings.budget.confidence,
          settings.srgb};
}

PassHistory::PassHistory(const RenderSettings& settings, const Film& film, bool is_watched, const ErrorMeasure& measure,
                         LookAtDenoised look)
    : settings_(settings),
      film_(film),
      measure_(measure),
      are_counted_(settings.budget.IsOpen() || settings.wants_passes || settings.replay || is_watched),
      look_at_denoised_(std::move(look)) {}

void PassHistory::Resume(std::vector<Pass> passes, BlockErrors differences) {
  passes_ = std::move(passes);
  differences_ = std::move(differences);
}

std::optional<MeasuredError> PassHistory::Note(const Schedule& schedule, double samples, double seconds,
                                               const UnseenLight& unseen) {
  // A pass that was complete when the state was saved is already noted. Earlier passes are unknown.
  const std::uint32_t end = schedule.State().end;
  const bool is_noted = !passes_.empty() && passes_.back().end == end && passes_.back().samples == samples;
  const bool measures = (schedule.LooksAtError() || settings_.wants_passes) && !ShowsCosts(settings_.mode);
  const auto noisy = measures ? Measure(unseen) : std::nullopt;
  Look look{noisy};
  if (look_at_denoised_) look = noisy && schedule.LooksAtError() ? look_at_denoised_(*noisy, unseen) : Look{};
  if (look.was_stopped) return {};
  if (noisy && look_at_denoised_) noisy_ = noisy;
  // First looks do not count as passes, nor do the passes of a render without decisions.
  if (!passes_.empty() && !is_noted && (!are_counted_ || passes_.back().end == 0)) passes_.pop_back();
  if (is_noted) return look.error;
  passes_.push_back({end, samples, seconds, {}});
  // Errors that only a report requires must not affect those that decide, nor the final estimate.
  if (noisy && schedule.LooksAtError()) differences_ = noisy->differences;
  if (look.error) passes_.back().error = look.error->estimate;
  return look.error;
}

std::optional<ErrorForecast> PassHistory::Forecast() const {
  return settings_.budget.error ? ForecastOf(passes_, *settings_.budget.error) : std::nullopt;
}

std::optional<ErrorEstimate> PassHistory::Finish(bool have_come, const UnseenLight& unseen) {
  // The error of costs is unknown: costs are summed, not the displayed colors.
  if (ShowsCosts(settings_.mode)) return {};
  if (!have_come && noisy_) return noisy_->estimate;
  if (!have_come && !look_at_denoised_ && !passes_.empty() && passes_.back().error) return passes_.back().error;
  const auto measured = Measure(unseen);
  if (!measured) return {};
  if (!passes_.empty() && !look_at_denoised_) passes_.back().error = measured->estimate;
  return measured->estimate;
}

std::optional<MeasuredError> PassHistory::Measure(const UnseenLight& unseen) const {
  auto measured = MeasureError(film_, measure_, &differences_);
  if (measured) AllowFor(unseen, measure_, *measured);
  return measured;
}

}  // namespace ray
