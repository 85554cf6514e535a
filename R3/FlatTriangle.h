#pragma once

#include <algorithm>

#include "R3/Numeric.h"
#include "R3/SurfacePlace.h"

/// Points on flat triangles, computed without branches, so that loops over many triangles become vector instructions.
namespace R3 {

/// Returns the point of a triangle with the given barycentric weights, whose sum is 1.
///   accuracy   Physically Based Rendering (2023), section 6.8.5: gamma(7) bounds the sum. The next test of the same
///              triangle adds up the distances of its corners, so its t is off by a fraction of the largest of them,
///              whatever the triangle's orientation: no ray may leave a triangle in the plane z = 0 from exactly z = 0
inline SurfacePlace PlaceOnTriangle(const Point& p, const Point& q, const Point& r, const Vector& weights) {
  const Vector a = weights.x * FromOrigin(p), b = weights.y * FromOrigin(q), c = weights.z * FromOrigin(r);
  const Point place = Point{} + (a + b + c);
  const auto distance = [&](const Point& corner) { return MaxComponent(Abs(corner - place)); };
  const double farthest = std::max(std::max(std::max(0.0, distance(p)), distance(q)), distance(r));
  const Vector magnitude = Abs(a) + Abs(b) + Abs(c);
  return {{place.x, place.y, place.z}, Gamma(7) * magnitude + Gamma(16) * Vector{farthest, farthest, farthest}};
}

/// Returns the unit normal on the side from which the corners are counterclockwise; zero for a triangle without area.
/// Sides so long or short that their products would exceed the range of doubles are scaled to about 1, which changes no
/// bit.
inline Vector FaceDirection(const Point& p, const Point& q, const Point& r) {
  const auto in_range = [](const Vector& side) {
    const double largest = MaxComponent(Abs(side)), square = largest * largest, scale = InversePower(largest);
    const double if_large = square >= least_square ? 1 : scale;
    return (square <= most_square ? if_large : scale) * side;
  };
  return BranchlessUnit(Cross(in_range(q - p), in_range(r - p)));
}

}  // namespace R3
