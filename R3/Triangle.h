#pragma once

#include <array>
#include <optional>

#include "R3/Hit.h"
#include "R3/Ray.h"

namespace R3 {

/// A ray made ready for triangle tests: axes permuted so that the direction's largest component is the third, and the
/// shear that turns the direction into that axis.
struct ShearedRay {
  explicit ShearedRay(const Ray& ray)
      : origin(ray.origin), z_axis(MaxAxis(ray.direction)), t_min(ray.t_min), t_max(ray.t_max) {
    z_scale = 1 / ray.direction[z_axis];
    x_shear = ray.direction[(z_axis + 1) % 3] * z_scale;
    y_shear = ray.direction[(z_axis + 2) % 3] * z_scale;
  }

  Point origin;
  int z_axis;
  double x_shear, y_shear, z_scale;
  double t_min, t_max;
};

/// Nearest crossing with a triangle seen from either side; Hit::u and v are the weights of corners 1 and 2.
///   accuracy  watertight: rays through an edge or a corner shared by triangles hit at least one of them, because a
///             corner's sheared place depends on ray and corner alone and the signs of the edge functions are exact
///   source    Woop, Benthin, Wald, Watertight ray/triangle intersection (2013); the edge functions, which they redo in
///             double precision when zero, are exact in sign here by a fused difference of products
std::optional<Hit> IntersectTriangle(const ShearedRay& ray, const std::array<Point, 3>& corners);

/// The same, compiled into its caller: for batches whose caller is itself compiled for an instruction set.
template <int z_axis>
inline std::optional<Hit> IntersectTriangleAlong(const ShearedRay& ray, const std::array<Point, 3>& corners) {
  constexpr int x_axis = (z_axis + 1) % 3, y_axis = (z_axis + 2) % 3;
  double x[3], y[3], z[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector v = corners[i] - ray.origin;
    z[i] = v[z_axis];
    x[i] = v[x_axis] - ray.x_shear * z[i];
    y[i] = v[y_axis] - ray.y_shear * z[i];
  }
  const double u = DifferenceOfProducts(x[2], y[1], y[2], x[1]);
  const double v = DifferenceOfProducts(x[0], y[2], y[0], x[2]);
  const double w = DifferenceOfProducts(x[1], y[0], y[1], x[0]);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {};
  const double sum = u + v + w;
  if (sum == 0) return {};  // edge-on
  const double t = (u * z[0] + v * z[1] + w * z[2]) / sum * ray.z_scale;
  if (!(t > ray.t_min) || !(t < ray.t_max)) return {};  // NaN fails both
  return Hit{t, v / sum, w / sum, 0};
}

inline std::optional<Hit> IntersectTriangleInline(const ShearedRay& ray, const std::array<Point, 3>& corners) {
  switch (ray.z_axis) {
    case 0:
      return IntersectTriangleAlong<0>(ray, corners);
    case 1:
      return IntersectTriangleAlong<1>(ray, corners);
    default:
      return IntersectTriangleAlong<2>(ray, corners);
  }
}

}  // namespace R3
