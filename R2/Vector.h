#pragma once

#include "R2/Point.h"

namespace R2 {

/// A displacement in the plane.
struct Vector {
  double x = 0, y = 0;

  friend bool operator==(const Vector&, const Vector&) = default;
};

inline Vector operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator+(Point a, Vector v) { return {a.x + v.x, a.y + v.y}; }
inline Vector operator*(double s, Vector v) { return {s * v.x, s * v.y}; }
inline double Dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

}  // namespace R2
