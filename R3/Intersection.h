#pragma once

#include "R2/Point.h"
#include "R3/Normal.h"
#include "R3/Point.h"
#include "R3/Ray.h"

namespace R3 {

/// What a texture shows beyond an end of v, as blending between the middles of its rows asks at the first and the last.
enum class VEnd : unsigned char {
  repeated,  // the other end: v is a circle, or says nothing about where the surface ends
  rim,       // the last row: the surface ends
  pole       // the last row, half a turn of u further: all of the row meets in a point, and beyond is its other side
};
/// At v = 0 and at v = 1. Both are repeated or neither is; then v is within them.
struct VEnds {
  VEnd low = VEnd::repeated, high = VEnd::repeated;
};

/// All that shading needs to know of a point on a surface.
struct SurfacePoint {
  Point position;
  Normal normal;  // geometric, unit, outward: away from the inside of a solid, by the right-hand rule for a triangle
  Normal shading_normal;  // what light sees; the geometric one unless a mesh brings smooth normals and the scene asks
  R2::Point uv;
  VEnds v_ends;
};

/// Where a ray meets a surface; made once per ray, for the nearest hit.
struct Intersection : SurfacePoint {
  Vector error;  // bound on the distance of `position` from the true surface, per axis
};

/// Where a new ray towards `direction` may start: on the side of the surface that it heads for, outside the
/// position's error, then one ulp further on each axis.
///   source   Pharr, Jakob, Humphreys, Physically Based Rendering (2023), section 6.8.6
Point SpawnPoint(const Intersection& surface, const Vector& direction);

}  // namespace R3
