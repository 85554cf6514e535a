#pragma once

#include <vector>

#include "source/film/Film.h"
#include "source/film/error/ImageError.h"

namespace ray {

/// Returns, for each block of the film, the largest difference between two adjacent pixels at least one of which is in
/// the block, in any channel, as `measure` counts it. Every pixel must have a sample.
std::vector<double> NeighborContrasts(const Film& film, const ErrorMeasure& measure);

}  // namespace ray
