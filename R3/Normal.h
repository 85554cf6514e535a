#pragma once

#include "R3/Vector.h"

namespace R3 {

/// A direction perpendicular to a surface. The inverse transpose transforms it, so that it stays perpendicular. It is a
/// separate type so that no other transform compiles.
struct Normal {
  double x = 0, y = 0, z = 0;

  friend bool operator==(const Normal&, const Normal&) = default;
};

inline Normal operator-(const Normal& n) { return {-n.x, -n.y, -n.z}; }
inline Vector AsVector(const Normal& n) { return {n.x, n.y, n.z}; }
inline Normal AsNormal(const Vector& v) { return {v.x, v.y, v.z}; }
inline double Dot(const Normal& n, const Vector& v) { return n.x * v.x + n.y * v.y + n.z * v.z; }

}  // namespace R3
