#pragma once

#include <array>
#include <string>
#include <vector>

#include "R3/Intersection.h"
#include "source/accelerate/World.h"
#include "source/integrate/shading/Absorption.h"
#include "source/scene/LightBound.h"

namespace ray {

/// An emissive triangle, as a light (the 2008 course). Each of its points shines like a point light of its emission
/// without attenuation, to both sides, but not onto the triangle itself.
struct EmissiveTriangle {
  std::array<R3::Point, 3> corners;  // in the world
  R3::Vector corner_error;           // bound of their rounding error, per axis
  R3::Vector motion;                 // while the shutter is open
  R3::Normal normal;
  double area = 0;
  R2::Color emission;
  EmissionBehind behind;
  const Instance* instance = nullptr;
  std::int64_t primitive = 0;

  /// Returns the point that `random`, in [0, 1)^2, picks uniformly by area at a time in [0, 1), moved off the triangle
  /// to the side of `seen_from`, so that a ray from there to it stops short of the triangle.
  R3::Point PointTowards(const R3::Point& seen_from, const R2::Point& random, double time) const;

  /// Returns the radiance that arrives from one of its points, that far away.
  R2::Color RadianceAlong(const R3::Vector& way) const { return EmittedBackAlong(way, normal, emission, behind); }

  /// Returns bounds of the triangle during the whole shutter interval.
  R3::Box Bounds() const;
  std::string Describe() const;
  /// Returns the estimated contribution that light selection uses. Ignores attenuation, as in the course.
  LightBound Bound() const;
};

/// Returns every emissive triangle of every mesh (a `tri` is a mesh).
std::vector<EmissiveTriangle> EmissiveTriangles(const World& world);

}  // namespace ray
