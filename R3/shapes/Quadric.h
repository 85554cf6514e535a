#pragma once

#include <optional>

#include "R3/Point.h"

namespace R3 {

/// Both t where |origin + t direction - center| = radius, in order.
struct Roots {
  double first = 0, second = 0;
};

/// Whether a ray certainly begins outside and heads away from the center, as most do that begin on the surface: then
/// it has no crossing at t > 0. At a place outside by a few u of the radius it is nearly always certain.
///   from_center   origin - center, as it is rounded
///   accuracy      the sum of squares and that of the radius together are off by less than 8 u, as is the product with
///                 the direction; rays that begin outside by a share e of the radius and still meet the sphere have a
///                 cosine of -sqrt(2 e), which is far from a rounding error
inline bool IsCertainlyLeaving(const Vector& from_center, const Vector& direction, double radius) {
  constexpr double least = 0x1p-900;  // above it nothing of a sum is lost to underflow
  const double square = Dot(from_center, from_center), away = Dot(from_center, direction);
  return (square > (1 + 8 * unit_roundoff) * (radius * radius)) & (square > least) & (away > least);
}

/// Where a line crosses a sphere, or, with all y set to 0, a circular cylinder about the y axis.
///   returns   nothing on a miss, for a zero direction, and if an input is NaN
///   accuracy  the points lie within 8 u (D + radius) of the surface, D the distance of origin from center; a root that
///             is small because the origin lies just off the surface has a small RELATIVE error
///             (tests/extremes/sphere.cpp)
///   source    Haines, Guenther, Akenine-Moeller, Precision improvements for ray/sphere intersection, Ray Tracing Gems
///             (2019), ch. 7: the discriminant from the miss distance, the small root as c / q. Their c cancels when
///             the origin is near the surface; there it is summed exactly instead, and the plain discriminant is then
///             the better one, since b^2 and a c no longer cancel except at a tangent.
std::optional<Roots> QuadricRoots(const Point& origin, const Vector& direction, const Point& center, double radius);

}  // namespace R3
