#pragma once

#include <cstdint>
#include <vector>

#include "source/film/Film.h"
#include "source/render/Render.h"

namespace ray {

/// The progress of a render, in the unit that decides its end: milliseconds of a time limit, pixels of a pass, or
/// samples.
class PassProgress {
 public:
  /// `left_alone`: the blocks of other parts; empty if all blocks are rendered. The first two arguments must outlive
  /// this.
  PassProgress(const RenderSettings& settings, const Film& film, std::vector<bool> left_alone)
      : settings_(settings), film_(film), left_alone_(std::move(left_alone)) {}

  /// Begins a pass.
  void Begin(const PassTargets& targets);
  /// The samples per pixel, on average, before and after the pass.
  double SamplesBefore() const { return samples_before_; }
  double SamplesAfter() const { return samples_after_; }

  /// Sets the expected number of samples per pixel at which the error target is reached; 0 if it is unknown.
  void Expect(double samples) { samples_expected_ = samples; }

  /// Returns the progress.
  ///   pixels    pixels of the pass at their targets
  ///   seconds   since the program began
  RenderProgress Of(std::int64_t pixels, double seconds, std::uint64_t rays) const;

 private:
  const RenderSettings& settings_;
  const Film& film_;
  const std::vector<bool> left_alone_;
  double samples_before_ = 0, samples_after_ = 0;
  double idle_pixels_ = 0;  // in blocks that are at their targets before the pass
  double samples_expected_ = 0;
};

}  // namespace ray
