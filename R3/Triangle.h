#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "R3/Hit.h"
#include "R3/Ray.h"

namespace R3 {

/// The axes permuted for a ray's shear: the third is that of the direction's largest component, the others follow it
/// cyclically.
struct ShearAxes {
  explicit ShearAxes(const Vector& direction) : z(MaxAxis(direction)) {
    constexpr int next[3] = {1, 2, 0};
    x = next[z];
    y = next[x];
  }

  template <typename Xyz>
  Vector Permuted(const Xyz& p) const {
    return {LookUp(p, x), LookUp(p, y), LookUp(p, z)};
  }

  int x, y, z;

 private:
  /// Selects by memory access rather than branches, since rays of all directions come in no order.
  template <typename Xyz>
  static double LookUp(const Xyz& xyz, int axis) {
    static_assert(sizeof(Xyz) == 3 * sizeof(double));
    double coordinate;
    std::memcpy(&coordinate, reinterpret_cast<const char*>(&xyz) + sizeof(double) * static_cast<std::size_t>(axis),
                sizeof coordinate);
    return coordinate;
  }
};

/// A ray prepared for triangle tests: axes permuted, and the shear that maps the direction to the third axis.
struct ShearedRay {
  explicit ShearedRay(const Ray& ray)
      : axes(ray.direction), origin(axes.Permuted(ray.origin)), t_min(ray.t_min), t_max(ray.t_max) {
    const Vector along = axes.Permuted(ray.direction);
    z_scale = 1 / along.z;
    x_shear = along.x * z_scale;
    y_shear = along.y * z_scale;
  }

  ShearAxes axes;
  Vector origin;  // permuted
  double x_shear, y_shear, z_scale;
  double t_min, t_max;
};

/// Returns the nearest crossing with a triangle from either side; Hit::u and v are the weights of corners 1 and 2.
///   accuracy  watertight: rays through an edge or a corner shared by triangles hit at least one of them, because a
///             corner's sheared position depends on ray and corner alone and the signs of the edge functions are exact
///   source    Woop, Benthin, Wald, Watertight ray/triangle intersection (2013); the edge functions, which they
///             recompute in
///             double precision when zero, are exact in sign here by a fused difference of products
std::optional<Hit> IntersectTriangle(const ShearedRay& ray, const std::array<Point, 3>& corners);

/// Completes the test, with corners scaled by a power of two, if the areas of the sheared corners leave the range of
/// doubles, or nearly.
std::optional<Hit> IntersectScaledTriangle(const ShearedRay& ray, const double (&x)[3], const double (&y)[3],
                                           const double (&z)[3]);

/// Twice the signed areas between the origin of the sheared plane, through which the ray passes, and each edge, named
/// by the opposite corner. Their signs are exact.
struct EdgeFunctions {
  double u, v, w;

  EdgeFunctions(const double (&x)[3], const double (&y)[3])
      : u(DifferenceOfProducts(x[2], y[1], y[2], x[1])),
        v(DifferenceOfProducts(x[0], y[2], y[0], x[2])),
        w(DifferenceOfProducts(x[1], y[0], y[1], x[0])) {}
  /// Returns true if both signs occur; the ray then misses the triangle.
  bool HaveBothSigns() const {
    const double least = std::min(u, std::min(v, w)), most = std::max(u, std::max(v, w));
    return std::min(-least, most) > 0;
  }
  double Sum() const { return u + v + w; }
};

/// Makes the hit from edge functions of equal sign, whose sum is not 0.
inline std::optional<Hit> TriangleHit(const ShearedRay& ray, const EdgeFunctions& edges, const double (&z)[3]) {
  const double sum = edges.Sum();
  const double t = (edges.u * z[0] + edges.v * z[1] + edges.w * z[2]) / sum * ray.z_scale;
  if (!(t > ray.t_min) || !(t < ray.t_max)) return {};  // NaN fails both
  return Hit{t, edges.v / sum, edges.w / sum, 0};
}

/// IntersectTriangle inlined into batches that are compiled for an instruction set. Corners are read in place.
inline std::optional<Hit> IntersectTriangleInline(const ShearedRay& ray, const std::array<const Point*, 3>& corners) {
  double x[3], y[3], z[3];
#pragma GCC unroll 3
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector v = ray.axes.Permuted(*corners[i]) - ray.origin;
    z[i] = v.z;
    x[i] = v.x - ray.x_shear * v.z;
    y[i] = v.y - ray.y_shear * v.z;
  }
  const EdgeFunctions edges(x, y);
  if (edges.HaveBothSigns()) return {};
  if (!IsInRange(std::abs(edges.Sum()))) [[unlikely]] {  // 0 if seen edge-on
    // Uses copies, since arguments passed by address would force all triangles through memory.
    const auto scaled = IntersectScaledTriangle(ray, {x[0], x[1], x[2]}, {y[0], y[1], y[2]}, {z[0], z[1], z[2]});
    if (!scaled) return {};
    return Hit{scaled->t, scaled->u, scaled->v, scaled->part};
  }
  return TriangleHit(ray, edges, z);
}

}  // namespace R3
