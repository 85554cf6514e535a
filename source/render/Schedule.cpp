#include "source/render/Schedule.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "R1/Elementary.h"
#include "source/render/FirstLook.h"
#include "source/render/forecast/TimeBudget.h"

namespace ray {
namespace {

constexpr std::uint32_t most_samples = 1u << 30;      // per pixel and stream, if nothing else ends the render
constexpr std::uint32_t planned_if_unknown = 16;      // samples for which strata are laid out if no count is known
constexpr std::uint32_t first_with_error_target = 8;  // of each stream, before any other decision
constexpr std::uint32_t first_that_may_do = 4;        // of each stream, before the error can end the render
constexpr double share_of_time_at_once = 0.6;         // of the time left, for a pass of uncertain speed
constexpr double share_of_time_not_used = 0.01;       // too little for another pass
constexpr double seconds_without_news = 1;            // limit for taking the first sample of all pixels in one pass
constexpr double fall_of_error = 0.75;                // error ~ samples^-this, to estimate the required samples

bool HasCeiling(const RenderSettings& settings) { return !settings.budget.IsOpen() || settings.samples > 1; }

/// Returns the limit of samples per pixel and stream.
std::uint32_t Ceiling(const RenderSettings& settings) {
  if (!HasCeiling(settings)) return most_samples;
  const auto samples = static_cast<std::uint32_t>(settings.samples);
  return HasTwoStreams(settings) ? std::max(1u, samples / 2) : samples;
}

/// Returns the samples per pixel and stream at the first decision.
std::uint32_t FirstDecision(const RenderSettings& settings) {
  const std::uint32_t planned = settings.replay ? settings.replay->planned_samples / 2 : Ceiling(settings);
  const bool looks_at_error = settings.replay ? settings.replay->looked_at_error : settings.budget.error.has_value();
  return std::clamp(planned, 1u, looks_at_error ? first_with_error_target : 1u);
}

/// Returns the first block of the square that a block belongs to.
std::size_t FirstOfSquare(const BlockGrid& blocks, std::size_t block) {
  const auto columns = static_cast<std::size_t>(blocks.columns), side = static_cast<std::size_t>(blocks.together);
  return block / columns / side * side * columns + block % columns / side * side;
}

/// Replaces deviations by those of whole squares.
void AverageInSquares(const BlockGrid& blocks, std::vector<double>& deviations) {
  std::vector<double> sums(deviations.size()), areas(deviations.size());
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const std::size_t first = FirstOfSquare(blocks, i);
    sums[first] += blocks.areas[i] * deviations[i] * deviations[i];
    areas[first] += blocks.areas[i];
  }
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const std::size_t first = FirstOfSquare(blocks, i);
    deviations[i] = areas[first] > 0 ? std::sqrt(sums[first] / areas[first]) : 0;
  }
}

/// Adds one sample to some blocks if there is no time for one in all: that many of those with the fewest samples,
/// spread evenly. Squares gain together.
void RaiseSome(std::vector<std::uint32_t>& targets, const std::vector<std::uint32_t>& done, double blocks,
               const BlockGrid& grid) {
  std::uint32_t fewest = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t i = 0; i < done.size(); ++i)
    if (targets[i] > done[i]) fewest = std::min(fewest, done[i]);
  const auto is_raised = [&](std::size_t i) {
    return FirstOfSquare(grid, i) == i && targets[i] > done[i] && done[i] == fewest;
  };
  blocks /= grid.together * grid.together;
  double candidates = 0;
  for (std::size_t i = 0; i < done.size(); ++i) candidates += is_raised(i);
  const double share = blocks / candidates;
  double place = 0;  // steps of the golden ratio, whose successive values are spread over (0, 1)
  for (std::size_t i = 0; i < done.size(); ++i) {
    const bool is_candidate = is_raised(i);
    if (is_candidate) place = std::fmod(place + 1 / std::numbers::phi, 1);
    const bool is_chosen = is_candidate && place < share && blocks >= 1;
    blocks -= is_chosen;
    targets[i] = done[i] + is_chosen;
  }
  for (std::size_t i = 0; i < done.size(); ++i) {
    const std::size_t first = FirstOfSquare(grid, i);
    targets[i] = done[i] + (targets[first] - done[first]);
  }
}

/// Reduces the samples that each block would gain to a share, or the number of blocks that gain one. Returns the
/// largest target of those that still gain any; 0 if none does.
std::uint32_t Shorten(std::vector<std::uint32_t>& targets, const std::vector<std::uint32_t>& done, double share,
                      const BlockGrid& grid) {
  double most = 0, all = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    most = std::max(most, share * (targets[i] - done[i]));
    all += share * (targets[i] - done[i]);
  }
  if (most < 1)
    RaiseSome(targets, done, all, grid);
  else
    for (std::size_t i = 0; i < targets.size(); ++i)
      targets[i] = done[i] + static_cast<std::uint32_t>(share * (targets[i] - done[i]));
  std::uint32_t end = 0;
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (targets[i] > done[i]) end = std::max(end, targets[i]);
  return end;
}

}  // namespace

std::uint32_t PlannedSamples(const RenderSettings& settings) {
  if (settings.replay) return settings.replay->planned_samples;
  return HasCeiling(settings) ? static_cast<std::uint32_t>(settings.samples) : planned_if_unknown;
}

bool HasTwoStreams(const RenderSettings& settings) {
  return settings.replay ? settings.replay->two_streams : settings.denoise || settings.budget.error.has_value();
}

std::uint32_t MostSamples(const RenderSettings& settings) {
  return settings.replay ? std::ranges::max(settings.replay->ends) : Ceiling(settings);
}

Schedule::Schedule(const RenderSettings& settings, BlockGrid blocks, bool in_passes)
    : budget_(settings.budget),
      replay_(settings.replay),
      blocks_(std::move(blocks)),
      pixels_(std::accumulate(blocks_.areas.begin(), blocks_.areas.end(), 0.0)),
      in_passes_(budget_.IsOpen() || in_passes || !ShowsCosts(settings.mode)),
      two_streams_(HasTwoStreams(settings)),
      looks_at_neighbors_(SamplesWhereNeighborsDiffer(settings)),
      most_places_(IsSubsampled(settings) ? settings.places : BlockOrder::places),
      is_subsampled_(IsSubsampled(settings)),
      ceiling_(Ceiling(settings)),
      first_decision_(FirstDecision(settings)) {
  if (replay_)
    ReplayTo(replay_->ends.front());
  else if (!ShowsCosts(settings.mode))
    LookAt(1);
  else
    SampleTo(in_passes_ ? 1 : ceiling_);
}

void Schedule::SampleTo(std::uint32_t end) {
  state_.end = end;
  state_.targets = {std::vector<std::uint32_t>(blocks_.areas.size(), end)};
}

void Schedule::LookAt(int places) {
  state_.end = 0;
  state_.targets = LookTargets(blocks_.areas.size(), places);
}

void Schedule::Resume(ScheduleState state) {
  if (replay_) {
    while (state_.end < state.end && !NextOfReplay()) continue;
  } else if (in_passes_) {
    state_ = std::move(state);
  }
}

void Schedule::SkipToRound() {
  while (!NeedsWholeImage() && !Next({})) continue;
}

std::optional<Stop> Schedule::Next(const PassOutcome& pass) {
  if (replay_) return NextOfReplay();
  if (state_.end == 0) return NextOfFirstSamples(pass);
  if (looks_at_neighbors_) return NextOfNeighbors(pass);
  const MeasuredError* error = DecidesByError() && pass.error ? &*pass.error : nullptr;
  const MeasuredError* noisy = error && pass.noisy ? &*pass.noisy : nullptr;
  if (pass.error && Suffices(*pass.error)) return Stop::error;
  if (error && pass.has_stalled && ceiling_ == most_samples && budget_.seconds == 0) return Stop::stall;
  const bool goes_as_far_as_time = pass.is_of_many_machines && budget_.seconds > 0 && !budget_.error;
  const std::uint32_t next = noisy ? NextEndIfDenoised(*error, *noisy) : NextEnd(error);
  std::uint32_t end = goes_as_far_as_time ? ceiling_ : std::min(ceiling_, next);
  std::vector<std::uint32_t> targets(blocks_.areas.size(), end);
  if (error && budget_.adaptive != Adaptive::off) targets = ChooseBlocks(end, *error, noisy);
  // After a pass that was shortened for some blocks, others may already have more.
  for (std::size_t i = 0; i < targets.size(); ++i) targets[i] = std::max(targets[i], state_.targets.samples[i]);
  if (targets == state_.targets.samples) return Stop::samples;
  if (budget_.seconds > 0) end = ShortenToTime(targets, end, pass);
  if (end == 0) return Stop::time;
  state_.end = end;
  state_.targets.samples = std::move(targets);
  return {};
}

/// Returns true if an error after the current pass is small enough to end the render. For coarse targets it is measured
/// once before it decides anything else; if it is too large, that has no effect. Since its history is unknown then, its
/// square counts as if it had not fallen when the samples were last doubled.
///   accuracy   20 scenes with 6 seeds and targets of 16/255, 8/255 and 4/255: 176 of 360 renders end there, and none
///              of
///              these has a true error above the target; without that doubling more would end, some of them above it
bool Schedule::Suffices(const MeasuredError& error) const {
  if (!LooksAtError() || state_.end < std::min(ceiling_, first_that_may_do)) return false;
  return Caution() * error.square_high <= SquaredTargetOf(error);
}

/// Looks at that many places, or takes the first sample of all pixels if these are all places.
void Schedule::LookOn(int places) {
  if (!is_subsampled_ && places >= BlockOrder::places)
    SampleTo(1);
  else
    LookAt(std::min(places, most_places_));
}

/// Continues until every pixel has its first sample, or all that should have one; if that takes long, first with twice
/// as many places.
std::optional<Stop> Schedule::NextOfFirstSamples(const PassOutcome& pass) {
  const int places = state_.targets.places.front();
  if (is_subsampled_ && places >= most_places_) return Stop::samples;
  const double samples_left = (two_streams_ ? 2 : 1) - static_cast<double>(places) / BlockOrder::places;
  const double pace = pass.samples_taken > 0 ? pass.seconds_taken / pass.samples_taken : 0;  // seconds per sample
  const bool is_short = pace * samples_left <= seconds_without_news;
  int next = 2 * places;
  if (budget_.seconds > 0) {
    const double left = SecondsLeft(pass), usable = share_of_time_at_once * left;
    if (left < share_of_time_not_used * budget_.seconds) return Stop::time;
    if (pace > 0 && usable < (pace + pass.seconds_after_per_sample) * samples_left) {
      constexpr double place = 1.0 / BlockOrder::places;
      if (places == BlockOrder::places) return Stop::time;
      next = std::min(next, places + std::max(1, static_cast<int>(usable / (pace * place))));
      LookAt(std::min(next, most_places_));
      return {};
    }
  }
  LookOn(is_short ? BlockOrder::places : next);
  return {};
}

/// Takes all samples in blocks in which neighboring pixels differ by more than a level after the first sample, and in
/// those that already took more. Elsewhere the image is smooth: its mean over a pixel differs from one sample in it by
/// at most half of the difference to the neighbors on the left and right, plus half of that to those above and below,
/// so by a level.
std::optional<Stop> Schedule::NextOfNeighbors(const PassOutcome& pass) {
  constexpr double level = 1.0 / 255;
  std::vector<std::uint32_t> targets = state_.targets.samples;
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (LooksAtContrast() ? pass.contrasts[i] > level : targets[i] > 1) targets[i] = ceiling_;
  if (targets == state_.targets.samples) return Stop::samples;
  state_.end = ceiling_;
  state_.targets.samples = std::move(targets);
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
  SampleTo(end);
  for (std::size_t i = 0; i < replay_->samples.size(); ++i)
    state_.targets.samples[i] = std::min(end, replay_->samples[i]);
  state_.targets.places = replay_->places;
}

/// Returns twice the samples, or fewer if the error is close to its target: a multiple of a large power of two, at
/// which the sequences are well distributed. In between, errors may even rise: for scenes/camera_motion.scn from
/// 0.95/255 at 16 samples of each stream to 1.10/255 at 19, before they fall to 0.76/255 at 24 and 0.54/255 at 32.
std::uint32_t Schedule::NextEnd(const MeasuredError* error) const {
  const std::uint32_t end = state_.end, twice = 2 * end;  // fits, since -samples is an int
  if (!error) return twice;
  const double growth = R1::Pow(error->square_high / SquaredTargetOf(*error), 0.5 / fall_of_error);
  return growth < 1.7 ? RoundedUp(growth) : twice;
}

/// Returns the samples so far times `growth`, rounded up to a quarter of a power of two.
std::uint32_t Schedule::RoundedUp(double growth) const {
  const std::uint32_t end = state_.end, step = std::max(1u, std::bit_floor(end) / 4);
  const auto wanted = std::max(end, static_cast<std::uint32_t>(growth * end));
  return (wanted / step + 1) * step;
}

/// Returns the samples at the next look at a denoised image. Each look requires filtering, so there are few: far from
/// the target, the next one is at half of the samples that are expected to suffice; close to it, at slightly more than
/// these. If the image is soon good enough without denoising, the next look is then.
///   source   squared errors of denoised images fall as samples^-0.7 to samples^-1.3 in the scenes of
///            script/time_to_error.sh
std::uint32_t Schedule::NextEndIfDenoised(const MeasuredError& error, const MeasuredError& noisy) const {
  constexpr double far = 4, farthest = 32, margin = 1.1, most_growth = 3;
  const double target = SquaredTargetOf(error), ratio = error.square / target;
  if (noisy.square_high < far * SquaredTargetOf(noisy)) return NextEnd(&noisy);
  if (ratio >= far && state_.end < most_samples / farthest)
    return state_.end * std::bit_floor(static_cast<std::uint32_t>(std::min(ratio, farthest) / 2));
  return RoundedUp(std::min(most_growth, margin * error.square_high / target));
}

/// Returns the deviation of a sample in each block. A measurement may be small by chance, so it counts as at least half
/// of a neighbor's; and no block of a denoised image counts as better filtered than the image.
///   noisy   the error without denoising; null if the image is not denoised
std::vector<double> Schedule::DeviationsOf(const MeasuredError& error, const MeasuredError* noisy) const {
  constexpr double share_of_neighbor = 0.5;
  const double share_of_noise = noisy && noisy->square > 0 ? error.square / noisy->square : 0;
  const int columns = blocks_.columns, rows = static_cast<int>(blocks_.areas.size()) / columns;
  const auto measured = [&](int row, int column) {
    const auto block = static_cast<std::size_t>(row * columns + column);
    const double least = noisy ? share_of_noise * noisy->square_of_blocks[block] : 0;
    // Differences of squares may be negative.
    return std::sqrt(std::max({0.0, least, error.square_of_blocks[block]}) * state_.targets.samples[block]);
  };
  std::vector<double> deviations;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      double deviation = measured(row, column);
      for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
          deviation = std::max(deviation, share_of_neighbor * measured(r, c));
      deviations.push_back(deviation);
    }
  if (blocks_.together > 1) AverageInSquares(blocks_, deviations);
  return deviations;
}

/// Returns targets with which only blocks continue that have fewer samples than the best allocation gives them. The
/// fewest samples that reach a squared error are in proportion to the deviations:
///     samples = deviation * mean deviation / squared error.
/// If all blocks have these, but the interval's upper end is still above the target, they are allocated for half of the
/// squared error, and so on. To find rare light, no deviation counts as less than a quarter of the mean: with a half,
/// direct light takes 1.3 times the samples, and no more of 216 renders are below their target
/// (script/claims_table.sh). All blocks continue while light that no sample has found may be an important part of the
/// error.
///   source   Neyman, On the two different aspects of the representative method (1934)
std::vector<std::uint32_t> Schedule::ChooseBlocks(std::uint32_t end, const MeasuredError& error,
                                                  const MeasuredError* noisy) const {
  constexpr double most_unseen = 0.05, least_share_of_mean = 0.25;
  const std::vector<std::uint32_t>& done = state_.targets.samples;
  std::vector<std::uint32_t> targets(done.size(), end);
  const std::vector<double> deviations = DeviationsOf(error, noisy);
  const double mean = std::inner_product(deviations.begin(), deviations.end(), blocks_.areas.begin(), 0.0) / pixels_;
  if (error.estimate.unseen_share > most_unseen || !(mean > 0)) return targets;
  bool any = false;
  for (double square = SquaredTargetOf(error); !any && square > 0; square /= 2)
    for (std::size_t i = 0; i < done.size(); ++i) {
      const bool is_open = std::max(deviations[i], least_share_of_mean * mean) * mean > square * done[i];
      targets[i] = is_open ? end : done[i];
      any |= is_open;
    }
  return targets;
}

/// Returns the seconds until the image has to be finished.
double Schedule::SecondsLeft(const PassOutcome& pass) const {
  return share_of_time_aimed_at * budget_.seconds - pass.now - pass.seconds_after;
}

/// Shortens the next pass, which would end at `end`, to the time that is left. Returns its end then; 0 if there is no
/// time.
std::uint32_t Schedule::ShortenToTime(std::vector<std::uint32_t>& targets, std::uint32_t end,
                                      const PassOutcome& pass) const {
  const std::vector<std::uint32_t>& done = state_.targets.samples;
  const double left = SecondsLeft(pass);
  if (left < share_of_time_not_used * budget_.seconds) return 0;
  double samples = 0;
  for (std::size_t i = 0; i < targets.size(); ++i)
    samples += blocks_.areas[i] * (two_streams_ ? 2 : 1) * (targets[i] - done[i]);
  // The fraction of the pass for which there is time. Each pass near the end leaves time for another, so that only the
  // last and shortest can be misjudged.
  const double pace = pass.seconds_taken / pass.samples_taken + pass.seconds_after_per_sample;
  double share = share_of_time_at_once * left / (pace * (samples / pixels_));
  // Without a pass that shows the speed, take one sample. Rounding (about 1e-15) must not reduce it to none.
  constexpr double above_rounding = 1 + 1e-9;
  if (!(pass.samples_taken > 0)) share = above_rounding / (end - state_.end);
  return share >= 1 ? end : Shorten(targets, done, share, blocks_);
}

double Schedule::SquaredTargetOf(const MeasuredError& error) const {
  return SquaredTarget(budget_.error->value, {.unit = budget_.error->unit}, error.mean);
}

}  // namespace ray
