#pragma once

#include <chrono>
#include <string>

#include "source/render/Render.h"

namespace ray {

/// The display of progress: none, one line that is rewritten on a terminal, or occasional lines in a log.
enum class ProgressStyle { none, terminal, log };

/// Returns the style that suits standard error.
ProgressStyle ChooseProgressStyle(bool quiet);

/// Returns " 42%  0:12 left  14.2 Mrays/s", `seconds` after the phase began; after the samples " 42%  0:12 left
/// denoising".
std::string ProgressText(const RenderProgress& progress, double seconds);
/// Returns "0:07" or "1:02:03".
std::string DurationText(double seconds);

/// Reports the progress of a render on standard error. Write errors are ignored.
class Progress {
 public:
  explicit Progress(ProgressStyle style);
  ~Progress();  // removes the terminal's line

  void Update(const RenderProgress& progress);

 private:
  bool IsDue(const RenderProgress& progress) const;

  using Clock = std::chrono::steady_clock;
  ProgressStyle style_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  std::int64_t tenths_shown_ = 0;
  RenderPhase phase_ = RenderPhase::samples;
  bool has_line_ = false;
};

}  // namespace ray
