#pragma once

#include "R3/Point.h"

namespace R3 {

/// A place on a surface, and a bound on its distance from the true one, per axis.
struct SurfacePlace {
  Point position;
  Vector error;
};

}  // namespace R3
