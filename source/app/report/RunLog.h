#pragma once

#include <optional>

#include "source/accelerate/Accelerator.h"
#include "source/app/report/Resources.h"
#include "source/app/report/RunStats.h"

namespace ray {

/// Collects what happens in a run, and says on standard error what its user should know at once: warnings
/// always, steps with -verbose.
class RunLog {
 public:
  /// `words`: the command line, as typed.
  explicit RunLog(std::span<const std::string> words);

  /// `all`: the options, with the scene's own settings.
  void Loaded(const ParsedScene& parsed, RenderOptions all);
  void Built(const World& world, const Accelerator& accelerator);
  /// Before the first sample of a render with a time limit: what its image takes without any, by the budget that the
  /// render has.
  void WillFinishIn(const Budget& budget);
  /// With a time limit that machines share: since when, in seconds.
  void BeganTogether(double seconds_ago) { shared_before_ = seconds_ago - SecondsSoFar(); }
  void Rendered(const RenderResult& result);
  /// With what -reference names, in the unit of the estimated error.
  void Compared(double true_error);
  /// `picture`: where it went.
  void Written(const std::string& picture);
  /// Hints at the reason if the image is black. That takes some rays, so the image is written before.
  void ExplainIfBlack(const World& world, const Accelerator& accelerator, const R2::Image& image);
  /// The results, on standard output, unless -quiet. Throws OutputError when statistics that were asked for cannot be
  /// written.
  void Summarize() const;

  const RunStats& stats() const { return stats_; }
  double SecondsSoFar() const { return watch_.Total(); }

 private:
  void Warn(const std::string& line);
  /// A warning that -quiet silences.
  void Hint(const std::string& line);
  void PrintStep(const std::string& step, double seconds) const;

  Stopwatch watch_;
  std::optional<double> shared_before_;  // seconds of other machines before this process began
  RunStats stats_;
};

}  // namespace ray
