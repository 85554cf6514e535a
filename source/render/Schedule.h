#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "source/film/error/ImageError.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// The reason why a render ended.
enum class Stop { samples, time, error, stall, request };
inline constexpr std::array stop_names{"samples", "time", "error", "stall", "request"};

/// Returns the number of samples per pixel for which strata and camera rays are laid out.
std::uint32_t PlannedSamples(const RenderSettings& settings);
/// Returns true if half of the samples come from a second, independent stream, so that their difference shows the
/// error.
bool HasTwoStreams(const RenderSettings& settings);

/// Returns the maximum samples per pixel and stream that a block can be due.
std::uint32_t MostSamples(const RenderSettings& settings);

/// The blocks of a film, in rows.
struct BlockGrid {
  int columns = 1;
  std::vector<double> areas;  // of each block, in pixels of the image
  int together = 1;           // side, in blocks, of the squares that have equal targets
};

/// The targets of a pass.
struct PassTargets {
  std::vector<std::uint32_t> samples;  // per pixel and stream, of each block
  // The number of places of BlockOrder that take their first sample, for each block whose entry in `samples` is 0;
  // empty if there are none.
  std::vector<std::uint8_t> places{};

  int PlacesOf(int block) const { return places.empty() ? 0 : places[static_cast<std::size_t>(block)]; }
  friend bool operator==(const PassTargets&, const PassTargets&) = default;
};

/// The results of a completed pass that a schedule needs.
struct PassOutcome {
  double now = 0;            // seconds since the program began
  double seconds_taken = 0;  // by the pass
  double samples_taken = 0;  // by the pass, per pixel, on average; 0: it was complete before an interruption
  std::optional<MeasuredError> error;
  // Seconds from the last sample to the written image, and the additional seconds per further sample per pixel.
  double seconds_after = 0, seconds_after_per_sample = 0;
  bool has_stalled = false;          // see ErrorForecast
  bool is_of_many_machines = false;  // each pass starts them again, so there should be few
  std::vector<double> contrasts{};   // of neighboring pixels as displayed, in [0, 1], per block; see LooksAtContrast
  std::optional<MeasuredError> noisy{};  // without denoising, if `error` is that of the denoised image
};

/// The state of a schedule, saved in checkpoints.
struct ScheduleState {
  PassTargets targets;  // of the current pass
  std::uint32_t end = 0;  // target of the blocks that take part in the pass
};

/// Decides after each pass which blocks of an image continue, up to which number of samples, and when to stop. It
/// neither traces nor reads a clock: its caller provides all data. The first pass takes a pixel of each block, so that
/// there is an image at once and the speed is known; if all first samples would take long, more pixels follow. Then
/// each pass doubles the samples, or takes fewer if the error is close to its target or the time is almost over. An
/// error that does not fall ends a render without other limits. Modes that show costs, which depend on the order of
/// rays, have one pass without a budget. A replay repeats the passes of an earlier render.
class Schedule {
 public:
  /// `in_passes`: double the samples pass by pass in any mode.
  Schedule(const RenderSettings& settings, BlockGrid blocks, bool in_passes);

  const ScheduleState& State() const { return state_; }
  /// Returns true if the next decision depends on the error of the image after the current pass.
  bool DecidesByError() const { return budget_.error && !replay_ && state_.end >= first_decision_; }
  /// Returns true if the error after the current pass is measured: if it decides; if the next one does, which is
  /// compared with it; or in a replay, if the replayed render did. An error that is small enough ends the render.
  bool LooksAtError() const {
    const bool looks = replay_ ? replay_->looked_at_error : budget_.error.has_value();
    return looks && 2 * state_.end >= first_decision_;
  }
  /// Returns the factor by which a squared error must be below its target to end the render.
  double Caution() const { return DecidesByError() ? 1 : 2; }
  bool Suffices(const MeasuredError& error) const;
  /// Returns true if the next decision depends on the contrast of neighboring pixels after the current pass.
  bool LooksAtContrast() const { return looks_at_neighbors_ && state_.end == 1; }
  /// Returns true if the next decision depends on the whole image after the current pass, or on the time it took.
  bool NeedsWholeImage() const {
    return LooksAtError() || LooksAtContrast() || (budget_.seconds > 0 && state_.end > 0);
  }
  /// Skips to the first pass after which a decision needs the whole image, or to the last pass. The samples of blocks
  /// do not depend on the skipped passes.
  void SkipToRound();
  /// Continues from the state of another schedule of this image.
  void Resume(ScheduleState state);

  /// Chooses the next pass, when every block is at its target; or returns the reason why there is none.
  std::optional<Stop> Next(const PassOutcome& pass);

 private:
  std::optional<Stop> NextOfReplay();
  void ReplayTo(std::uint32_t end);
  void SampleTo(std::uint32_t end);
  void LookAt(int places);
  std::optional<Stop> NextOfFirstSamples(const PassOutcome& pass);
  void LookOn(int places);
  std::optional<Stop> NextOfNeighbors(const PassOutcome& pass);
  double SecondsLeft(const PassOutcome& pass) const;
  std::uint32_t NextEnd(const MeasuredError* error) const;
  std::uint32_t NextEndIfDenoised(const MeasuredError& error, const MeasuredError& noisy) const;
  std::uint32_t RoundedUp(double growth) const;
  std::vector<double> DeviationsOf(const MeasuredError& error, const MeasuredError* noisy) const;
  std::vector<std::uint32_t> ChooseBlocks(std::uint32_t end, const MeasuredError& error,
                                          const MeasuredError* noisy) const;
  std::uint32_t ShortenToTime(std::vector<std::uint32_t>& targets, std::uint32_t end, const PassOutcome& pass) const;
  double SquaredTargetOf(const MeasuredError& error) const;

  Budget budget_;
  std::optional<Replay> replay_;
  BlockGrid blocks_;
  double pixels_;  // of the image
  bool in_passes_, two_streams_, looks_at_neighbors_;
  int most_places_;  // looked at in a block without samples
  bool is_subsampled_;
  std::uint32_t ceiling_, first_decision_;  // samples per pixel and stream
  ScheduleState state_;
};

}  // namespace ray
