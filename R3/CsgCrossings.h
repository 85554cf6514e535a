#pragma once

#include <cstdint>

#include "R1/StackVector.h"
#include "R3/Csg.h"

namespace R3 {

/// Where a line goes into a solid of a Csg or out of it.
struct CsgCrossing {
  double t = 0;              // that Intersect of the solid gives
  double low = 0, high = 0;  // what it is within in spite of rounding
  int element = 0;           // of the solid
  std::uint32_t part = 0;    // the solid
  bool enters = false;
};

using CsgCrossings = R1::StackVector<CsgCrossing, 24>;

/// Appends the crossings of a solid with all of a ray's line, each later than the last, in and out by turns. An element
/// that is crossed more often than 16,384 times counts up to there, and ends there: no shape comes near.
///   ray   finite, with a direction
void AddCrossings(const CsgSolid& solid, const Ray& ray, CsgCrossings& crossings);

}  // namespace R3
