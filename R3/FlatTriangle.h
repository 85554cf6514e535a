#pragma once

#include <algorithm>

#include "R3/Numeric.h"
#include "R3/SurfacePlace.h"

/// Places on flat triangles, without branches, so that loops over many of them become vector instructions.
namespace R3 {

/// The mean of the corners by weights whose sum is 1.
///   accuracy   Physically Based Rendering (2023), section 6.8.5: gamma(7) for the sum. The next test of the same
///              triangle sums its corners' distances, so its t errs by a share of the largest of them whichever way the
///              triangle lies: a triangle in the plane z = 0 must not be left from z = 0 exactly
inline SurfacePlace PlaceOnTriangle(const Point& p, const Point& q, const Point& r, const Vector& weights) {
  const Vector a = weights.x * FromOrigin(p), b = weights.y * FromOrigin(q), c = weights.z * FromOrigin(r);
  const Point place = Point{} + (a + b + c);
  const auto distance = [&](const Point& corner) { return MaxComponent(Abs(corner - place)); };
  const double farthest = std::max(std::max(std::max(0.0, distance(p)), distance(q)), distance(r));
  const Vector magnitude = Abs(a) + Abs(b) + Abs(c);
  return {{place.x, place.y, place.z}, Gamma(7) * magnitude + Gamma(16) * Vector{farthest, farthest, farthest}};
}

/// Twice its area along the direction from which the corners turn counter-clockwise.
inline Vector AreaOfTriangle(const Point& p, const Point& q, const Point& r) { return Cross(q - p, r - p); }
/// Whether its unit vector is the triangle's normal to the last bits.
inline bool IsSafeArea(const Vector& area) {
  const double largest = MaxComponent(Abs(area));
  return (largest >= least_square) & (largest <= most_square);
}

/// Unit, on the side from which the corners turn counter-clockwise; zero for a triangle without area.
inline Vector FaceDirection(const Point& p, const Point& q, const Point& r) {
  const Vector area = AreaOfTriangle(p, q, r);
  if (IsSafeArea(area)) return Unit(area);
  const Vector a = q - p, b = r - p;
  const double longest_a = MaxComponent(Abs(a)), longest_b = MaxComponent(Abs(b));
  if (!(longest_a > 0 && longest_b > 0 && longest_a < infinity && longest_b < infinity)) return Unit(area);
  return Unit(Cross(ScaledByPower(a, -std::ilogb(longest_a)), ScaledByPower(b, -std::ilogb(longest_b))));
}

}  // namespace R3
