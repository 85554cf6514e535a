#pragma once

#include <array>
#include <optional>

#include "R3/Hit.h"
#include "R3/Ray.h"

namespace R3 {

/// A ray made ready for triangle tests: axes permuted so that the direction's largest component is the third, and the
/// shear that turns the direction into that axis.
struct ShearedRay {
  explicit ShearedRay(const Ray& ray);

  Point origin;
  int x_axis, y_axis, z_axis;
  double x_shear, y_shear, z_scale;
  double t_min, t_max;
};

/// Nearest crossing with a triangle seen from either side; Hit::u and v are the weights of corners 1 and 2.
///   accuracy  watertight: rays through an edge or a corner shared by triangles hit at least one of them, because a
///             corner's sheared place depends on ray and corner alone and the signs of the edge functions are exact
///   source    Woop, Benthin, Wald, Watertight ray/triangle intersection (2013); the edge functions, which they redo in
///             double precision when zero, are exact in sign here by a fused difference of products
std::optional<Hit> IntersectTriangle(const ShearedRay& ray, const std::array<Point, 3>& corners);

}  // namespace R3
