#pragma once

#include <string>

#include "source/view/live/RenderJob.h"
#include "source/view/live/TracedImages.h"

namespace ray {

/// Returns the progress of a job: "4 of 16 samples 31 % 0.5 Mrays/s 12 s left", "8 samples until stopped 0.5
/// Mrays/s"; ClaimOf has the result of a budget.
std::string StatusOf(const RenderJob& job);

/// Returns the claim of a complete job: "estimated error 1.8/255 (1.7 to 1.9), 64 samples".
std::string ClaimOf(const RenderResult& result);

/// The progress of the image, as text that changes slowly enough to be read.
class RenderStatus {
 public:
  /// `now`: in seconds of ticks.
  void Update(const TracedImages& traced, double now);
  /// "4 of 16 samples 31 % 0.5 Mrays/s 12 s left"; empty without any image.
  const std::string& Text() const { return text_; }
  /// Returns "30% of the light ended at -max_depth 3, -min_luminance 0.01" for a complete image that is too dark by
  /// that much; empty for others.
  const std::string& MissingLight() const { return missing_light_; }

 private:
  struct Seen {
    std::uint64_t job = 0;
    int samples = 0;
    bool has_ended = false;
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  std::string text_, missing_light_;
  Seen seen_;          // what the text was made for
  double since_ = -1;  // seconds of ticks
};

}  // namespace ray
