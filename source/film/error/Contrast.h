#pragma once

#include <vector>

#include "source/film/Film.h"
#include "source/film/error/PictureError.h"

namespace ray {

/// The largest difference between two pixels beside or above each other, of which one at least is in the block: of
/// each block of the film, in any channel, as `measure` looks at them. Every pixel has a sample.
std::vector<double> NeighborContrasts(const Film& film, const ErrorMeasure& measure);

}  // namespace ray
