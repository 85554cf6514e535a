#pragma once

#include <array>
#include <string>
#include <vector>

#include "R3/Intersection.h"
#include "source/accelerate/World.h"
#include "source/integrate/shading/Absorption.h"
#include "source/scene/LightBound.h"

namespace ray {

/// A triangle whose material emits, as a light (the 2008 course): from each of its points it shines like a point light
/// of its emission without fall-off, to both sides, but not onto itself.
struct EmissiveTriangle {
  std::array<R3::Point, 3> corners;  // in the world
  R3::Vector corner_error;           // bound on what rounding moved them by, per axis
  R3::Vector motion;                 // while the shutter is open
  R3::Normal normal;
  double area = 0;
  R2::Color emission;
  EmissionBehind behind;
  const Instance* instance = nullptr;
  std::int64_t primitive = 0;

  /// The point that `random`, in [0, 1)^2, picks evenly by area at a time in [0, 1), moved off the triangle to the side
  /// of `seen_from`, so that a ray from there to it stops short of the triangle.
  R3::Point PointTowards(const R3::Point& seen_from, const R2::Point& random, double time) const;

  /// What arrives from one of its points, that far away.
  R2::Color RadianceAlong(const R3::Vector& way) const { return EmittedBackAlong(way, normal, emission, behind); }

  /// Around wherever it is while the shutter is open.
  R3::Box Bounds() const;
  std::string Describe() const;
  /// What choosing among lights goes by, without fall-off as the course has it.
  LightBound Bound() const;
};

/// Every triangle of every mesh (a `tri` is one) that emits.
std::vector<EmissiveTriangle> EmissiveTriangles(const World& world);

}  // namespace ray
