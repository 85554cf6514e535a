#pragma once

#include "R3/Vector.h"

namespace R3 {

/// Returns the axis of the smallest component, the first one of equals: a cross product with it is far from 0.
inline Vector LeastAxis(const Vector& v) {
  const Vector a = Abs(v);
  return a.x <= a.y && a.x <= a.z ? Vector{1, 0, 0} : a.y <= a.z ? Vector{0, 1, 0} : Vector{0, 0, 1};
}

}  // namespace R3
