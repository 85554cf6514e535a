#pragma once

#include <chrono>
#include <string>

#include "source/render/Render.h"

namespace ray {

/// How to say how far a render is: not at all, on one line that a terminal rewrites, or now and then a line in a log.
enum class ProgressStyle { none, terminal, log };

/// What standard error is good for.
ProgressStyle ChooseProgressStyle(bool quiet);

/// " 42%  0:12 left  14.2 Mrays/s", `seconds` after the phase began; but for samples " 42%  0:12 left  denoising".
std::string ProgressText(const RenderProgress& progress, double seconds);
/// "0:07", "1:02:03"
std::string DurationText(double seconds);

/// Says on standard error how far a render is. Whether anybody listens does not matter to it.
class Progress {
 public:
  explicit Progress(ProgressStyle style);
  ~Progress();  // takes the terminal's line away

  void Update(const RenderProgress& progress);

 private:
  bool IsDue(const RenderProgress& progress) const;

  using Clock = std::chrono::steady_clock;
  ProgressStyle style_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  std::int64_t tenths_told_ = 0;
  RenderPhase phase_ = RenderPhase::samples;
  bool has_line_ = false;
};

}  // namespace ray
