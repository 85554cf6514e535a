#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "source/film/error/PictureError.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// Why a render ended.
enum class Stop { samples, time, error, stall, request };
inline constexpr std::array stop_names{"samples", "time", "error", "stall", "request"};

/// How many samples per pixel strata and camera rays are laid out for.
std::uint32_t PlannedSamples(const RenderSettings& settings);
/// Whether half of the samples come from a second, independent stream, so that their difference shows the error.
bool HasTwoStreams(const RenderSettings& settings);

/// The most samples per pixel and stream that a block can be due.
std::uint32_t MostSamples(const RenderSettings& settings);

/// The blocks of a film, in rows.
struct BlockGrid {
  int columns = 1;
  std::vector<double> areas;  // of each block, in pixels of the picture
};

/// What a pass is to reach.
struct PassTargets {
  std::vector<std::uint32_t> samples;  // per pixel and stream, of each block
  // How many places of BlockOrder take their first sample, of each block whose entry in `samples` is 0; empty for none.
  std::vector<std::uint8_t> places{};

  int PlacesOf(int block) const { return places.empty() ? 0 : places[static_cast<std::size_t>(block)]; }
  friend bool operator==(const PassTargets&, const PassTargets&) = default;
};

/// What a schedule learns about a pass that is over.
struct PassOutcome {
  double now = 0;            // seconds since the program began
  double seconds_taken = 0;  // by the pass
  double samples_taken = 0;  // by the pass, per pixel, on average; 0: it was over before a break
  std::optional<MeasuredError> error;
  // That come once no more samples are taken, until the picture is written, and how many more a sample per pixel adds.
  double seconds_after = 0, seconds_after_per_sample = 0;
  bool has_stalled = false;          // see ErrorForecast
  bool is_of_many_machines = false;  // which begin anew for each pass, so that there should be few
  std::vector<double> contrasts{};   // of neighboring pixels as displayed, in [0, 1], per block; see LooksAtContrast
};

/// Where a schedule stands; kept in checkpoints.
struct ScheduleState {
  PassTargets targets;                      // of the pass that runs
  std::vector<double> last_squared_errors;  // of the blocks, when that pass was chosen; empty where none were measured
  std::uint32_t end = 0;                    // the target of the blocks that take part in the pass
};

/// Decides between two passes over an image which blocks continue, to how many samples, and when to stop. It traces
/// nothing and reads no clock: all it knows comes from its caller. The first pass takes a pixel of each block, so that
/// there is an image at once and the speed is known; if all first samples would take long, more pixels follow. Then
/// each pass doubles the samples, or takes fewer where the error is nearly down to its target or the time is nearly
/// over. An error that does not fall ends a render that nothing else would end. Modes that show costs, which depend on
/// the order of rays, are one pass without a budget. A replay repeats the passes of an earlier render.
class Schedule {
 public:
  /// `in_passes`: double the samples pass by pass whatever the mode.
  Schedule(const RenderSettings& settings, BlockGrid blocks, bool in_passes);

  const ScheduleState& State() const { return state_; }
  /// Whether the error of the picture, after the pass that runs, bears on what is next.
  bool DecidesByError() const { return budget_.error && !replay_ && state_.end >= first_decision_; }
  /// Or on the first error that does, since that is compared with it; and if it is small enough it ends the render. In
  /// a replay, whether it did.
  bool LooksAtError() const {
    const bool looks = replay_ ? replay_->looked_at_error : budget_.error.has_value();
    return looks && 2 * state_.end >= first_decision_;
  }
  /// How many times a squared error must be below its target to end the render.
  double Caution() const { return DecidesByError() ? 1 : 2; }
  /// Whether what is next depends on how neighboring pixels differ after the pass that runs.
  bool LooksAtContrast() const { return looks_at_neighbors_ && state_.end == 1; }
  /// Whether what is next depends on the whole picture after the pass that runs, or on the time it took.
  bool NeedsWholePicture() const {
    return LooksAtError() || LooksAtContrast() || (budget_.seconds > 0 && state_.end > 0);
  }
  /// Goes on to the first pass after which a decision needs the whole picture, or to the last pass. No block's samples
  /// depend on the passes in between.
  void SkipToRound();
  /// Goes on where another schedule of this picture stood.
  void Resume(ScheduleState state);

  /// Chooses the next pass, now that every block is at its target; or says why there is none.
  std::optional<Stop> Next(const PassOutcome& pass);

 private:
  bool Suffices(const MeasuredError& error) const;
  std::optional<Stop> NextOfReplay();
  void ReplayTo(std::uint32_t end);
  void SampleTo(std::uint32_t end);
  void LookAt(int places);
  std::optional<Stop> NextOfFirstSamples(const PassOutcome& pass);
  void LookOn(int places);
  std::optional<Stop> NextOfNeighbors(const PassOutcome& pass);
  double SecondsLeft(const PassOutcome& pass) const;
  std::uint32_t NextEnd(const MeasuredError* error) const;
  std::uint32_t NextEndIfDenoised(const MeasuredError& error) const;
  std::uint32_t RoundedUp(double growth) const;
  std::vector<std::uint32_t> ChooseBlocks(std::uint32_t end, const MeasuredError& error);
  bool IsOpen(std::size_t block, const std::vector<double>& squares, double limit) const;
  bool HidesAnywhere(const MeasuredError& error, const std::vector<double>& squares) const;
  double ShareOfSurprise(const std::vector<double>& squares, double target) const;
  std::uint32_t ShortenToTime(std::vector<std::uint32_t>& targets, std::uint32_t end, const PassOutcome& pass) const;
  double SquaredTargetOf(const MeasuredError& error) const;

  Budget budget_;
  std::optional<Replay> replay_;
  BlockGrid blocks_;
  double pixels_;  // of the picture
  bool in_passes_, two_streams_, looks_at_neighbors_, is_denoised_;
  int most_places_;  // of a block that are looked at where it has no samples
  bool is_subsampled_;
  std::uint32_t ceiling_, first_decision_;  // samples per pixel and stream
  ScheduleState state_;
};

}  // namespace ray
