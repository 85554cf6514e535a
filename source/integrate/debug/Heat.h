#pragma once

#include "R2/Color.h"
#include "source/accelerate/Counts.h"

namespace ray {

/// What a ray cost, in things looked at: nodes, cells or leaves gone through, and primitives asked.
double Heat(const Counts& cost);

/// A cost as a color on one scale for all pictures, so that they can be compared: black at 1 and below, then blue at
/// 10, red at 100, yellow at 1,000, white at 10,000 and above, evenly in the logarithm between.
R2::Color HeatColor(double heat);

}  // namespace ray
