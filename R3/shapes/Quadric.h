#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "R3/Numeric.h"
#include "R3/Point.h"

namespace R3 {

/// Both t where |origin + t direction - center| = radius, in order.
struct Roots {
  double first = 0, second = 0;
};

/// Returns true if a point is certainly outside and heads away from the center, as most points do from which rays leave
/// the surface: there is then no crossing ahead. At a distance of a few u of the radius outside it is nearly always
/// certain.
///   from_center   point - center, as it is rounded
///   accuracy      the sum of squares and that of the radius together are off by less than 8 u, as is the product with
///                 the direction; rays that begin outside by a share e of the radius and still meet the sphere have a
///                 cosine of -sqrt(2 e), which is far from a rounding error
inline bool IsCertainlyLeaving(const Vector& from_center, const Vector& direction, double radius) {
  constexpr double least = 0x1p-900;  // above it no sum loses bits to underflow
  const double square = Dot(from_center, from_center), away = Dot(from_center, direction);
  return (square > (1 + 8 * unit_roundoff) * (radius * radius)) & (square > least) & (away > least);
}

/// Returns the crossings of a line with a sphere or, with all y set to 0, a circular cylinder about the y axis.
///   returns   std::nullopt on a miss, for a zero direction, and if an input is NaN
///   accuracy  the points lie within 8 u (D + radius) of the surface, D the distance of origin from center; a root that
///             is small because the origin lies just off the surface has a small RELATIVE error
///             (tests/extremes/sphere.cpp)
///   source    Haines, Guenther, Akenine-Moeller, Precision improvements for ray/sphere intersection, Ray Tracing Gems
///             (2019), ch. 7: the discriminant from the miss distance, the small root as c / q. Their c cancels when
///             the origin is near the surface; there it is summed exactly instead, and the plain discriminant is then
///             the better one, since b^2 and a c no longer cancel except at a tangent.
std::optional<Roots> QuadricRoots(const Point& origin, const Vector& direction, const Point& center, double radius);

/// QuadricRoots for lengths whose squares leave the range of doubles, or nearly.
std::optional<Roots> ScaledQuadricRoots(const Point& origin, const Vector& direction, const Point& center,
                                        double radius);

/// The coefficients of a t^2 - 2 b t + c, whose roots are wanted, and b^2 - a c.
struct Quadratic {
  double a, b, c, discriminant;
};
/// Returns the equation of a ray that starts near the surface.
Quadratic QuadraticNearby(const Point& origin, const Vector& direction, const Point& center, double radius);

/// QuadricRoots inlined into callers that are compiled for an instruction set.
inline std::optional<Roots> QuadricRootsInline(const Point& origin, const Vector& direction, const Point& center,
                                               double radius) {
  // Nearer to the surface than this share of the radius, (F - r)(F + r) has lost at least three bits.
  constexpr double near_share = 0x1p-3;
  const Vector f = origin - center;
  const double square = Dot(f, f), distance = std::sqrt(square);
  Quadratic q{Dot(direction, direction), -Dot(f, direction), 0, 0};
  if (!IsInRange(q.a) || !IsInRange(std::max(square, radius * radius))) [[unlikely]]
    return ScaledQuadricRoots(origin, direction, center, radius);
  if (std::abs(distance - radius) < near_share * radius) {
    q = QuadraticNearby(origin, direction, center, radius);
  } else {
    q.c = (distance - radius) * (distance + radius);
    const double s = q.b / q.a;  // to the line's point nearest to the center; fma keeps the small difference
    const Vector miss{std::fma(s, direction.x, f.x), std::fma(s, direction.y, f.y), std::fma(s, direction.z, f.z)};
    const double miss_distance = std::sqrt(Dot(miss, miss));
    q.discriminant = q.a * ((radius - miss_distance) * (radius + miss_distance));
  }
  if (!(q.discriminant >= 0) || !(q.a > 0)) return {};
  const double sum = q.b + std::copysign(std::sqrt(q.discriminant), q.b);
  if (sum == 0) return Roots{0, 0};  // the origin is the point of tangency
  Roots roots{q.c / sum, sum / q.a};
  if (roots.first > roots.second) std::swap(roots.first, roots.second);
  return roots;
}

}  // namespace R3
