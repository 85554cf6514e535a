#include "source/render/Schedule.h"

#include <algorithm>
#include <cmath>

namespace ray {
namespace {

constexpr std::uint32_t most_samples = 1u << 30;      // per pixel and stream, where nothing else ends the render
constexpr std::uint32_t planned_if_unknown = 16;      // samples that strata are laid out for when no count is known
constexpr std::uint32_t first_with_error_target = 8;  // of each stream, before anything is decided
constexpr double seconds_to_finish_a_pixel = 150e-9;  // from sums to the bytes of a file
constexpr double share_of_time_aimed_at = 0.97;       // so that a pass may take longer than expected as well as shorter
constexpr double share_of_time_at_once = 0.6;         // of what is left, by a pass: its speed is known from others
constexpr double fall_of_error = 0.75;                // error ~ samples^-this, for guessing how many are needed
// No block stops early where most of the error is in outliers and blocks that seemed good enough before the last pass
// hold more than this share of the squared error now: there light is found so seldom that nothing tells where it will
// be found next. (Along the edge of a lamp few pixels hold the error as well, but stay few.)
constexpr double most_surprise = 0.05;

bool HasCeiling(const RenderSettings& settings) { return !settings.budget.IsOpen() || settings.samples > 1; }

/// Samples per pixel and stream.
std::uint32_t Ceiling(const RenderSettings& settings) {
  if (!HasCeiling(settings)) return most_samples;
  const auto samples = static_cast<std::uint32_t>(settings.samples);
  return HasTwoStreams(settings) ? std::max(1u, samples / 2) : samples;
}

/// Every block cut to a share of the samples that it would gain. The largest target of those that still gain any; 0
/// where none does.
std::uint32_t Shorten(std::vector<std::uint32_t>& targets, const std::vector<std::uint32_t>& done, double share) {
  std::uint32_t end = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    targets[i] = done[i] + static_cast<std::uint32_t>(share * (targets[i] - done[i]));
    if (targets[i] > done[i]) end = std::max(end, targets[i]);
  }
  return end;
}

}  // namespace

std::uint32_t PlannedSamples(const RenderSettings& settings) {
  if (settings.replay) return settings.replay->planned_samples;
  return HasCeiling(settings) ? static_cast<std::uint32_t>(settings.samples) : planned_if_unknown;
}

bool HasTwoStreams(const RenderSettings& settings) {
  return settings.replay ? settings.replay->two_streams : settings.budget.error.has_value();
}

Schedule::Schedule(const RenderSettings& settings, BlockGrid blocks, bool in_passes)
    : budget_(settings.budget),
      replay_(settings.replay),
      blocks_(std::move(blocks)),
      in_passes_(budget_.IsOpen() || in_passes),
      two_streams_(HasTwoStreams(settings)),
      ceiling_(Ceiling(settings)),
      first_decision_(std::min(ceiling_, budget_.error ? first_with_error_target : 1u)) {
  // Where the clock counts, even the first samples must not take longer than they may.
  state_.end = !in_passes_ ? ceiling_ : budget_.seconds > 0 ? 1 : first_decision_;
  state_.targets.assign(blocks_.areas.size(), state_.end);
  if (replay_) ReplayTo(replay_->ends.front());
}

void Schedule::Resume(ScheduleState state) {
  if (replay_) {
    while (state_.end < state.end && !NextOfReplay()) continue;
  } else if (in_passes_) {
    state_ = std::move(state);
  }
}

std::optional<Stop> Schedule::Next(const PassOutcome& pass) {
  if (replay_) return NextOfReplay();
  const bool decides_by_error = budget_.error && pass.error && state_.end >= first_decision_;
  const MeasuredError* error = decides_by_error ? &*pass.error : nullptr;
  if (error && error->square_high <= SquaredTargetOf(*error)) return Stop::error;
  if (state_.end >= ceiling_) return Stop::samples;
  std::uint32_t end = std::min(ceiling_, NextEnd(error));
  std::vector<std::uint32_t> targets(blocks_.areas.size(), end);
  if (error && budget_.adaptive != Adaptive::off) targets = ChooseBlocks(end, *error);
  if (budget_.seconds > 0) end = ShortenToTime(targets, end, pass);
  if (end == 0) return Stop::time;
  state_.end = end;
  state_.targets = std::move(targets);
  return {};
}

std::optional<Stop> Schedule::NextOfReplay() {
  for (const std::uint32_t end : replay_->ends)
    if (end > state_.end) {
      ReplayTo(end);
      return {};
    }
  return Stop::samples;
}

void Schedule::ReplayTo(std::uint32_t end) {
  state_.end = end;
  for (std::size_t i = 0; i < state_.targets.size(); ++i)
    state_.targets[i] = replay_->samples.empty() ? end : std::min(end, replay_->samples[i]);
}

/// Twice as many, or fewer when the error is close to its target.
std::uint32_t Schedule::NextEnd(const MeasuredError* error) const {
  const std::uint32_t end = state_.end, twice = end > most_samples / 2 ? most_samples : 2 * end;
  if (!error) return twice;
  const double growth = std::pow(error->square_high / SquaredTargetOf(*error), 0.5 / fall_of_error);
  if (!(growth < 1.7)) return twice;
  return std::min(twice, end + std::max(end / 8, static_cast<std::uint32_t>((growth - 1) * end)) + 1);
}

/// Targets where only blocks go on whose error is above the target, or a neighbor's is. One look may see a small error
/// by luck, so it takes two in a row to stop.
std::vector<std::uint32_t> Schedule::ChooseBlocks(std::uint32_t end, const MeasuredError& error) {
  constexpr double fall = 0.5;  // of a squared error, at least, when the samples are doubled
  const double target = SquaredTargetOf(error);
  const std::vector<double>& last = state_.last_squared_errors;
  std::vector<double> squares = error.square_of_blocks;
  const bool has_looked_before = !last.empty();
  const bool is_risky = error.estimate.IsMostlyOutliers() && ShareOfSurprise(squares, target) > most_surprise;
  for (std::size_t i = 0; i < last.size(); ++i) squares[i] = std::max(squares[i], fall * last[i]);
  state_.last_squared_errors = error.square_of_blocks;

  std::vector<std::uint32_t> targets(blocks_.areas.size(), end);
  if (!has_looked_before || is_risky) return targets;
  bool any = false;
  for (double limit = target; !any && limit > 0; limit /= 2)
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const bool is_open = IsOpen(i, squares, limit);
      targets[i] = is_open ? end : state_.targets[i];
      any |= is_open;
    }
  return targets;
}

bool Schedule::IsOpen(std::size_t block, const std::vector<double>& squares, double limit) const {
  const int columns = blocks_.columns, rows = static_cast<int>(blocks_.areas.size()) / columns;
  const int column = static_cast<int>(block) % columns, row = static_cast<int>(block) / columns;
  for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
    for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
      if (squares[static_cast<std::size_t>(r * columns + c)] > limit) return true;
  return false;
}

/// How much of the squared error is in blocks that would have stopped before the last pass; all of it before there was
/// one.
double Schedule::ShareOfSurprise(const std::vector<double>& squares, double target) const {
  if (state_.last_squared_errors.empty()) return 1;
  double surprise = 0, all = 0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    all += squares[i];
    if (!IsOpen(i, state_.last_squared_errors, target)) surprise += squares[i];
  }
  return all > 0 ? surprise / all : 0;
}

/// Shortens the next pass, which would go to `end`, to the time that is left. Where it ends then; 0: there is no time
/// for any.
std::uint32_t Schedule::ShortenToTime(std::vector<std::uint32_t>& targets, std::uint32_t end,
                                      const PassOutcome& pass) const {
  double pixels = 0, samples = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    pixels += blocks_.areas[i];
    samples += blocks_.areas[i] * (two_streams_ ? 2 : 1) * (targets[i] - state_.targets[i]);
  }
  const double left = share_of_time_aimed_at * budget_.seconds - pass.now - seconds_to_finish_a_pixel * pixels;
  const double one_sample = 1.0 / (end - state_.end);  // per pixel, as a share of the pass
  // How much of the pass there is time for. Where no pass tells how fast they are, one sample has to.
  const double affordable = pass.samples_taken > 0
                                ? left * pass.samples_taken / (pass.seconds_taken * (samples / pixels))
                            : left > 0 ? one_sample
                                       : 0;
  // Each pass near the end leaves time for another, so that only the last and shortest can be wrongly guessed.
  if (share_of_time_at_once * affordable >= 1) return end;
  if (!(affordable >= one_sample)) return 0;
  // A share that is one sample but for rounding (some 1e-15 of it) must not be shortened to none.
  constexpr double above_rounding = 1 + 1e-9;
  return Shorten(targets, state_.targets, std::max(share_of_time_at_once * affordable, above_rounding * one_sample));
}

double Schedule::SquaredTargetOf(const MeasuredError& error) const {
  return SquaredTarget(budget_.error->value, {.unit = budget_.error->unit}, error.mean);
}

}  // namespace ray
