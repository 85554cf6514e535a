#pragma once

#include "R2/Point.h"
#include "R3/Normal.h"
#include "R3/Point.h"
#include "R3/Ray.h"

namespace R3 {

/// All that shading needs to know of a point on a surface; made once per ray, for the nearest hit.
struct Intersection {
  Point position;
  Vector error;   // bound on the distance of `position` from the true surface, per axis
  Normal normal;  // geometric, unit, outward: away from the inside of a solid, by the right-hand rule for a triangle
  Normal shading_normal;  // what light sees; the geometric one unless a mesh brings smooth normals and the scene asks
  R2::Point uv;
};

/// Where a new ray towards `direction` may start: on the side of the surface that it heads for, outside the
/// position's error, then one ulp further on each axis.
///   source   Pharr, Jakob, Humphreys, Physically Based Rendering (2023), section 6.8.6
Point SpawnPoint(const Intersection& surface, const Vector& direction);

}  // namespace R3
