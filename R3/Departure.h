#pragma once

#include <algorithm>
#include <cmath>

#include "R3/Numeric.h"
#include "R3/Ray.h"

/// The rule by which paths leave a surface, so that no other surface that meets it there is skipped or seen from
/// behind.
///
/// Walls of a room meet in an edge, a glass stands on a floor, water fills a glass to its wall. A point that is moved
/// off one of two such surfaces along its normal may end up behind the other. But an arriving ray has crossed nothing
/// before its hit. So paths continue from a free point: on the arriving ray, a little before the hit.
///
/// Let u = 2^-53 and S the largest coordinate of the arriving ray's origin plus that of its way to the hit. The free
/// point is rounded by less than 3 u S. It lies before the hit by its clearance m from the surface,
///     m = 2^15 u S + e,
/// where e is more than eight times the error of the surface itself. It is therefore on the near side of any other
/// surface that meets there and whose angle with the ray is more than 2^-13 of that of the hit's own surface. Its
/// distance from the hit is at most a quarter of the arriving ray: far from the world's origin, m would exceed the
/// visible detail, and a smaller m is the best available. The clearance counts as at least 2^10 u S, so that a path
/// that advances less than 2^18 u S has not moved, see below.
///
/// A surface nearly parallel to the ray may still have the free point behind it, by some u S. So the sign of t does not
/// decide whether a new ray meets a surface near its start. A surface whose distance from the free point is within
/// their errors is assumed to contain the start, and the path's own history decides on which side of it the path is:
/// the side it came from, or the other side if it has crossed the surface here. With a the direction in which the path
/// arrived, n the surface's normal and d the new direction,
///     the surface is ahead   if and only if   (n.a)(n.d) > 0, unless it has been crossed, else < 0
/// (IsAhead in source/accelerate/Contact.h). For this, rays search from a t_min below 0, as far back as their line is
/// beyond the surface left. This fails only for a surface that ends where they meet and is nearly parallel both to the
/// arriving ray and to the new one: two chances of 2^-13.
///
/// Two triangles with a common edge divide space in two, and no line crosses both from the same side. A path that has
/// crossed one of them has therefore crossed both, however rounding moves it from one side of the edge to the other.
///
/// A path that meets the next surface right there has not moved: it continues from the same free point with the same
/// history. So mirrors in a corner, stacked panes, and a floor under a glass are met in order.
///   source   free points and history are our own derivation; for the bounds on errors see Physically
///            Based Rendering (2023), section 6.8
namespace R3 {

/// A primitive that a path has crossed where several surfaces meet, linked to those crossed there before.
struct Crossed {
  std::int64_t primitive = -1;
  Vector normal{};
  const Crossed* before = nullptr;
};

/// The state of a path that leaves a surface, for decisions about other surfaces that meet there.
struct Departure {
  double clearance = 0;              // distance of the free point from the surface along its normal, >= 0
  Vector arriving{};                 // the direction in which the path arrived
  const Crossed* crossed = nullptr;  // the primitives crossed here, the last one first

  /// Returns the distance from the free point within which surfaces may meet there: twice the clearance, so that it
  /// includes all surfaces that meet the surface left, plus the rounding of the point and of the distance compared with
  /// it.
  double Reach(const Point& free_point) const {
    return 2 * clearance + 32 * unit_roundoff * MaxComponent(Abs(FromOrigin(free_point)));
  }
  /// Returns the t_min of a ray from here. Its line is beyond the surface from -clearance / (n . d) on, which is
  /// farther back.
  double BeginTowards(const Vector& direction) const { return BeginTowards(clearance, direction); }
  static double BeginTowards(double clearance, const Vector& direction) {
    const Vector d = Abs(direction);
    return -clearance / (d.x + d.y + d.z);
  }
};

/// The maximum distance of a free point before its hit, as a share of the way to the hit.
inline constexpr double most_of_way = 0x1p-2;

/// The minimum clearance of a free point in units of u S: at smaller distances it cannot be distinguished from its
/// surface.
inline constexpr double least_clearance = 0x1p10;

/// A free point and its clearance.
struct FreePoint {
  Point place;
  double clearance;
};

/// Returns the free point before a hit. It has no branches, so that loops over many become vector instructions.
///   begin    the t at which the arriving ray began
///   facing   n . direction
///   error    e
inline FreePoint FreePointBefore(const Point& origin, const Vector& direction, double begin, double t, double facing,
                                 double error) {
  constexpr double share_of_size = 0x1p15 * unit_roundoff;
  const double size = MaxComponent(Abs(FromOrigin(origin))) + t * MaxComponent(Abs(direction));
  const double clearance = share_of_size * size + error;
  const double back = std::min(clearance / std::abs(facing), most_of_way * (t - begin));
  return {origin + (t - back) * direction, std::max(back * std::abs(facing), least_clearance * unit_roundoff * size)};
}

/// The distance that a ray travels from a surface, as a multiple of -t_min, until every surface it meets is outside the
/// reach of its departure, except surfaces that it meets at an angle of 2^-10 or less.
inline constexpr double departure_end = 0x1p12;

/// Returns true if t is so near to the ray's start that its departure must decide.
inline bool IsNearStart(const Ray& ray, double t) { return t < -departure_end * ray.t_min; }

/// Returns true if a ray leaves a surface and searches backward for others that meet there. Hits before its origin are
/// at its origin, within the errors.
inline bool IsDeparting(const Ray& ray) { return ray.t_min < 0 && ray.departure; }

/// Removes the departure of a ray that is stored; its line and time remain.
inline void ForgetDeparture(Ray& ray) {
  ray.departure = nullptr;
  ray.t_min = std::max(ray.t_min, 0.0);
}

/// Returns true if a ray that hits a surface at t has not moved from its departure: it has traveled less than 2^8 times
/// as far as its line may be behind the surface that it left.
inline bool HasNotMoved(const Ray& ray, double t) {
  constexpr double least_way = 0x1p8;
  return t < -least_way * ray.t_min;
}

}  // namespace R3
