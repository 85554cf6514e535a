#pragma once

#include "R3/Point.h"

namespace R3 {

/// A straight piece between two points.
struct Segment {
  Point start, end;
};

}  // namespace R3
