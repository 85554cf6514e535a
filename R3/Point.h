#pragma once

#include "R3/Vector.h"

namespace R3 {

/// A point in space.
struct Point {
  double x = 0, y = 0, z = 0;

  double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend bool operator==(const Point&, const Point&) = default;
};

inline Vector operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator+(const Point& p, const Vector& v) { return {p.x + v.x, p.y + v.y, p.z + v.z}; }
inline Point operator-(const Point& p, const Vector& v) { return {p.x - v.x, p.y - v.y, p.z - v.z}; }

/// Returns the displacement from the origin.
inline Vector FromOrigin(const Point& p) { return {p.x, p.y, p.z}; }

/// Returns p times 2^exponent, about the origin: exact within the range of doubles.
inline Point ScaledByPower(const Point& p, int exponent) {
  const Vector v = ScaledByPower(FromOrigin(p), exponent);
  return {v.x, v.y, v.z};
}

}  // namespace R3
