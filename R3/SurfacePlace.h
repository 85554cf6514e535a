#pragma once

#include "R3/Point.h"

namespace R3 {

/// A point on a surface, and a bound on its distance from the exact surface, per axis.
struct SurfacePlace {
  Point position;
  Vector error;
};

}  // namespace R3
