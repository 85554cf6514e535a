#pragma once

#include <cstdint>

#include "R1/StackVector.h"
#include "R3/Csg.h"

namespace R3 {

/// A point where a line enters or leaves a solid of a Csg.
struct CsgCrossing {
  double t = 0;              // as returned by the solid's Intersect
  double low = 0, high = 0;  // an interval that contains the exact t
  int element = 0;           // of the solid
  std::uint32_t part = 0;    // the part that is the solid
  bool enters = false;
};

using CsgCrossings = R1::StackVector<CsgCrossing, 24>;

/// Appends the crossings of a solid with the whole line of a ray, in ascending order, alternating between in and out.
/// Crossings of one element beyond the first 16,384 are ignored; no shape comes near that number.
///   ray   finite, with a direction other than 0
void AddCrossings(const CsgSolid& solid, const Ray& ray, CsgCrossings& crossings);

}  // namespace R3
