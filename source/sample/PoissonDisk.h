#pragma once

#include <cstdint>

#include "R2/Point.h"
#include "source/sample/Random.h"

namespace ray {

/// Place `index` of a sequence in the unit square in which any first n, up to 64, keep a distance from each other: none
/// are nearer than 0.55 / sqrt(n), across the square's edges too. Each 64 are the same ones, moved as a whole by a
/// random way that `key` says, so that every place is as likely.
///   source   Mitchell, Spectrally optimal sampling for distribution ray tracing (1991): each is the one farthest from
///            those before, of many candidates
R2::Point PoissonDiskPlace(std::uint32_t index, const RandomKey& key);

}  // namespace ray
