#include "source/render/PassHistory.h"

#include <utility>

namespace ray {

ErrorMeasure MeasureFor(const RenderSettings& settings) {
  return {settings.budget.error ? settings.budget.error->unit : ErrorUnit::display, settings.budget.confidence,
          settings.srgb};
}

PassHistory::PassHistory(const RenderSettings& settings, const Film& film, bool is_watched, const ErrorMeasure& measure)
    : settings_(settings),
      film_(film),
      measure_(measure),
      are_counted_(settings.budget.IsOpen() || settings.wants_passes || settings.replay || is_watched) {}

void PassHistory::Resume(std::vector<Pass> passes, BlockErrors differences) {
  passes_ = std::move(passes);
  differences_ = std::move(differences);
}

std::optional<MeasuredError> PassHistory::Note(const Schedule& schedule, double samples, double seconds,
                                               const UnseenLight& unseen) {
  // A pass that was over when it was kept is noted already, and what came before it is not known any more.
  const std::uint32_t end = schedule.State().end;
  const bool is_noted = !passes_.empty() && passes_.back().end == end && passes_.back().samples == samples;
  // First looks are no passes that anybody counts, nor are those of a render that has nothing to decide.
  if (!passes_.empty() && !is_noted && (!are_counted_ || passes_.back().end == 0)) passes_.pop_back();
  if (!is_noted) passes_.push_back({end, samples, seconds, {}});
  const bool measures = schedule.LooksAtError() || settings_.wants_passes;
  if (!measures || ShowsCosts(settings_.mode)) return {};
  auto error = Measure(unseen);
  if (!error || is_noted) return error;
  // Errors that a report alone asks for must not bear on those that decide, nor on what is claimed.
  if (schedule.LooksAtError()) differences_ = error->differences;
  passes_.back().error = error->estimate;
  return error;
}

std::optional<ErrorForecast> PassHistory::Forecast() const {
  return settings_.budget.error ? ForecastOf(passes_, *settings_.budget.error) : std::nullopt;
}

std::optional<ErrorEstimate> PassHistory::Finish(bool have_come, const UnseenLight& unseen) {
  // The error of costs is not known: they are what is summed, not the colors shown.
  if (ShowsCosts(settings_.mode)) return {};
  if (!have_come && !passes_.empty() && passes_.back().error) return passes_.back().error;
  const auto measured = Measure(unseen);
  if (!measured) return {};
  if (!passes_.empty()) passes_.back().error = measured->estimate;
  return measured->estimate;
}

std::optional<MeasuredError> PassHistory::Measure(const UnseenLight& unseen) const {
  auto measured = MeasureError(film_, measure_, &differences_);
  if (measured) AllowFor(unseen, measure_, *measured);
  return measured;
}

}  // namespace ray
