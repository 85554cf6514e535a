#pragma once

#include "R2/Point.h"
#include "R3/Normal.h"
#include "R3/Point.h"
#include "R3/Ray.h"

namespace R3 {

/// The texture rows beyond an end of v, which interpolation needs at the first and last row.
enum class VEnd : unsigned char {
  repeated,  // the other end: v is periodic, or unrelated to where the surface ends
  rim,       // the last row: the surface ends
  pole       // the last row, shifted by half a turn of u: the row is a single point, and beyond it is its other side
};
/// The ends at v = 0 and v = 1. Both are repeated or neither is; if neither, v stays within them.
struct VEnds {
  VEnd low = VEnd::repeated, high = VEnd::repeated;
};

/// The properties of a surface point that shading needs.
struct SurfacePoint {
  Point position;
  Normal normal;  // geometric, unit, outward: away from the inside of a solid, by the right-hand rule for a triangle
  Normal shading_normal;  // used for lighting; the geometric one unless the scene enables a mesh's smooth normals
  R2::Point uv;
  VEnds v_ends;
};

/// The point where a ray meets a surface; computed once per ray, for the nearest hit.
struct Intersection : SurfacePoint {
  Vector error;  // bound on the distance of `position` from the true surface, per axis
};

/// Returns a start point for a new ray towards `direction`: on the side of the surface that it heads for, outside the
/// position's error, then one ulp further on each axis.
///   source   Pharr, Jakob, Humphreys, Physically Based Rendering (2023), section 6.8.6
Point SpawnPoint(const Intersection& surface, const Vector& direction);

}  // namespace R3
