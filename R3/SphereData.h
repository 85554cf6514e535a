#pragma once

#include "R3/Point.h"

namespace R3 {

/// The center and radius of a sphere.
struct SphereData {
  Point center;
  double radius = 0;
};

}  // namespace R3
