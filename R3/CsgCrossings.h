#pragma once

#include <vector>

#include "R3/Csg.h"

namespace R3 {

/// Where a line goes into a solid of a Csg or out of it.
struct CsgCrossing {
  double t = 0;              // that Intersect of the solid gives
  double low = 0, high = 0;  // what it is within in spite of rounding
  bool enters = false;
  std::size_t part = 0;  // which solid; set by the caller
  int element = 0;       // of the solid
};

/// The crossings of a solid with all of a ray's line, each later than the last, in and out by turns. An element that
/// is crossed more often than 64 times counts up to there, and ends there: no shape that there is comes near.
std::vector<CsgCrossing> CrossingsOfSolid(const CsgPart& part, const ElementTree& elements, const Ray& ray);

}  // namespace R3
