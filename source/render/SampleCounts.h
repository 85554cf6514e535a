#pragma once

#include <cstdint>

#include "source/film/Film.h"

namespace ray {

/// Statistics of the samples per pixel over the image.
struct SampleCounts {
  std::uint32_t least = 0, most = 0;
  double mean = 0;
};
SampleCounts CountSamples(const Film& film);

/// Returns the number of samples so far, including those of the margin that a wide filter needs.
double SamplesTaken(const Film& film);

/// Returns the number of the block's pixels that have only their first sample, which is not in the film's sums yet.
std::int64_t PixelsLookedAt(const Film& film, int block);

}  // namespace ray
