#pragma once

#include <cstdint>

#include "R2/Point.h"
#include "source/sample/Random.h"

namespace ray {

/// Returns point `index` of a sequence in the unit square whose first n points, for n up to 64, keep a distance from
/// each other: at least 0.55 / sqrt(n), also across the square's edges. Each group of 64 repeats the same points,
/// shifted as a whole by a random vector that depends on `key`, so that every position is equally likely.
///   source   Mitchell, Spectrally optimal sampling for distribution ray tracing (1991): each point is the farthest
///            from
///            the earlier ones among many candidates
R2::Point PoissonDiskPlace(std::uint32_t index, const RandomKey& key);

}  // namespace ray
