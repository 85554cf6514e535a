#pragma once

#include <optional>

#include "source/accelerate/Accelerator.h"
#include "source/app/report/Resources.h"
#include "source/app/report/RunStats.h"

namespace ray {

/// The log of a run, which prints to standard error what its user should know at once: warnings always, steps with
/// -verbose.
class RunLog {
 public:
  /// Starts the log; `words` is the command line as typed.
  explicit RunLog(std::span<const std::string> words);

  /// Called after reading; `all` contains the options with the scene's own settings.
  void Loaded(const ParsedScene& parsed, RenderOptions all);
  void Built(const World& world, const Accelerator& accelerator, bool shares_light);
  /// Called before the first sample of a render with a time limit: warns if the fixed costs of the image in its budget
  /// exceed the limit.
  void WillFinishIn(const Budget& budget);
  /// Sets the start of a time limit that machines share, in seconds before now.
  void BeganTogether(double seconds_ago) { shared_before_ = seconds_ago - SecondsSoFar(); }
  void Rendered(const RenderResult& result);
  /// Sets the error against the images of -reference, in the unit of the estimated error.
  void Compared(double true_error);
  /// Called after writing; `image_file` is the file that was written.
  void Written(const std::string& image_file);
  /// Explains why the image is black, if it is. That takes some rays, so the image is written before.
  void ExplainIfBlack(const World& world, const Accelerator& accelerator, const R2::Image& image);
  /// Prints the results on standard output, unless -quiet. Throws OutputError if requested statistics cannot be
  /// written.
  void Summarize() const;

  const RunStats& stats() const { return stats_; }
  double SecondsSoFar() const { return watch_.Total(); }

 private:
  void Warn(const std::string& line);
  /// Prints a warning that -quiet silences.
  void Hint(const std::string& line);
  void PrintStep(const std::string& step, double seconds) const;

  Stopwatch watch_;
  std::optional<double> shared_before_;  // seconds of other machines before this process began
  RunStats stats_;
};

}  // namespace ray
