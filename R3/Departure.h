#pragma once

#include <algorithm>
#include <cmath>

#include "R3/Numeric.h"
#include "R3/Ray.h"

/// Where paths leave a surface, so that no other surface that meets it there is skipped or seen from behind.
///
/// Walls of a room meet in an edge, a glass stands on a floor, water fills a glass to its wall. A point that is moved
/// off one of two such surfaces along its normal may come to lie behind the other. But a ray that arrives has crossed
/// nothing before its hit. So paths go on from a free point: on the arriving ray, a little before the hit.
///
/// Let u = 2^-53 and S the largest coordinate of the arriving ray's origin plus that of its way to the hit. The free
/// point is rounded by less than 3 u S. It lies before the hit by its clearance m from the surface,
///     m = 2^15 u S + e,
/// e being more than eight times what the surface itself may be off by, and is hence on the near side of any other
/// surface that meets there and is tilted against the ray by more than 2^-13 of what the hit's own surface is. It is at
/// most a quarter of the arriving ray away from the hit: far from the world's origin, where m would be larger than what
/// is to be seen, less is as good as can be had. Its clearance counts as 2^10 u S at the least, so that a path that goes
/// less than 2^18 u S has not moved, see below.
///
/// What the ray is nearly parallel to may have the free point behind it all the same, by some u S. So whether a new ray
/// meets a surface near its start is not decided by the sign of t. A surface whose distance from the free point is
/// within their errors is taken to contain the start, and the path's own history tells on which side of it the path is:
/// where it came from, or if it has crossed the surface here, on the other. With a the direction in which the path
/// arrived, n the surface's normal and d the new direction,
///     the surface is ahead   if and only if   (n.a)(n.d) > 0, unless it has been crossed, else < 0
/// (IsAhead in source/accelerate/Contact.h). For this, rays search from a t_min below 0, as far back as their line is
/// beyond the surface left. This is wrong only for a surface that ends where they meet and is nearly parallel both to
/// the arriving ray and to the new one: two chances of 2^-13.
///
/// Two triangles with an edge in common part space in two, and no line crosses both from the same side. A path that has
/// crossed one of them has hence crossed both, however rounding moves it from one side of the edge to the other.
///
/// A path that meets the next surface right there has not moved: it goes on from the same free point with the same
/// history. So mirrors in a corner, stacked panes, and a floor under a glass are met one after the other.
///   source   free points and history are a derivation of our own; for the bounds on errors see Physically
///            Based Rendering (2023), section 6.8
namespace R3 {

/// A primitive that a path has crossed where several surfaces meet, and what it had crossed there before.
struct Crossed {
  std::int64_t primitive = -1;
  Vector normal{};
  const Crossed* before = nullptr;
};

/// What is known, where a path leaves a surface, of others that meet there.
struct Departure {
  double clearance = 0;              // of the surface from the free point, >= 0, along its normal
  Vector arriving{};                 // the direction in which the path came here
  const Crossed* crossed = nullptr;  // what it has crossed here, the last first

  /// A surface within this distance of the free point may be one that meets there: as far as the clearance, twice, so
  /// that all that meets the surface left is within it, and the roundings of the point and of what it is compared with.
  double Reach(const Point& free_point) const {
    return 2 * clearance + 32 * unit_roundoff * MaxComponent(Abs(FromOrigin(free_point)));
  }
  /// The t_min of a ray from here. Its line is beyond the surface from -clearance / (n . d) on, which is farther back.
  double BeginTowards(const Vector& direction) const { return BeginTowards(clearance, direction); }
  static double BeginTowards(double clearance, const Vector& direction) {
    const Vector d = Abs(direction);
    return -clearance / (d.x + d.y + d.z);
  }
};

/// No free point is farther before a hit than this share of the way to it.
inline constexpr double most_of_way = 0x1p-2;

/// What is nearer to a free point than this times u S is not told from its surface, so no clearance is less.
inline constexpr double least_clearance = 0x1p10;

/// A free point, and its clearance.
struct FreePoint {
  Point place;
  double clearance;
};

/// The free point before a hit, without branches, so that loops over many become vector instructions.
///   begin    where the arriving ray began
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

/// How far a ray that leaves a surface may go, as a multiple of -t_min, before no surface is nearer to its start than
/// the reach of its departure; but for surfaces that it meets at an angle of 2^-10 or less.
inline constexpr double departure_end = 0x1p12;

/// Whether t is so near to the ray's start that what is known of its departure must decide.
inline bool IsNearStart(const Ray& ray, double t) { return t < -departure_end * ray.t_min; }

/// Whether a ray leaves a surface and looks back for others that meet there. What it finds before its origin is at its
/// origin, within the errors.
inline bool IsDeparting(const Ray& ray) { return ray.t_min < 0 && ray.departure; }

/// Makes a ray independent of where it departed from, for keeping: its line and its moment stay.
inline void ForgetDeparture(Ray& ray) {
  ray.departure = nullptr;
  ray.t_min = std::max(ray.t_min, 0.0);
}

/// Whether a ray that hits a surface at t has not moved from where it departed: it has gone less than 2^8 times as far
/// as its line may be behind the surface that it left.
inline bool HasNotMoved(const Ray& ray, double t) {
  constexpr double least_way = 0x1p8;
  return t < -least_way * ray.t_min;
}

}  // namespace R3
