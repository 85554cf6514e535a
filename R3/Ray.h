#pragma once

#include <cstdint>

#include "R3/Point.h"

namespace R3 {

/// A half line, cut to the open interval (t_min, t_max). The direction may have any length: t counts in
/// lengths of it, so a ray seen from another frame keeps its t.
struct Ray {
  Point origin;
  Vector direction;
  double t_min = 0, t_max = infinity;
  double time = 0;  // when, of the time the shutter is open, in [0, 1)
  // Primitives that it cannot meet in between, as their owner numbers them; -1: none.
  std::int64_t leaving = -1;   // it starts there
  std::int64_t reaching = -1;  // it ends there

  Point At(double t) const { return origin + t * direction; }
};

}  // namespace R3
