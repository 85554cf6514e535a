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

/// Unit, on the side from which the corners turn counter-clockwise; zero for a triangle without area. Sides so long or
/// short that their products would leave the range of doubles are first brought to about 1, which changes no bit.
inline Vector FaceDirection(const Point& p, const Point& q, const Point& r) {
  const auto in_range = [](const Vector& side) {
    const double largest = MaxComponent(Abs(side)), square = largest * largest, scale = InversePower(largest);
    const double if_large = square >= least_square ? 1 : scale;
    return (square <= most_square ? if_large : scale) * side;
  };
  return BranchlessUnit(Cross(in_range(q - p), in_range(r - p)));
}

}  // namespace R3
