#pragma once

#include <vector>

#include "R3/Shape.h"
#include "tests/Draw.h"

/// What rays alone tell of a solid, whatever its shape.
namespace crossings {

/// Where a ray meets the surface, to its end, nearest first.
inline std::vector<double> Along(const R3::Shape& shape, R3::Ray ray) {
  std::vector<double> all;
  while (const auto hit = shape.Intersect(ray, 0)) all.push_back(hit->t), ray.t_min = hit->t;
  return all;
}

/// How often a ray meets the surface, to its end.
inline int Count(const R3::Shape& shape, const R3::Ray& ray) { return static_cast<int>(Along(shape, ray).size()); }

/// Whether no ray of many meets the surface more than twice.
inline bool IsConvex(const R3::Shape& shape) {
  const R3::Box box = Bounds(shape);
  Draw draw(77);
  for (int i = 0; i < 2000; ++i) {
    const R3::Vector direction = draw.Direction();
    const R3::Point near_middle = box.Center() + draw.Between(0, 0.5) * box.Radius() * draw.Direction();
    if (Count(shape, {near_middle - 3 * box.Radius() * direction, direction}) > 2) return false;
  }
  return true;
}

/// A point inside a solid: the middle of a convex one, of a chord through any other.
inline R3::Point PointInside(const R3::Shape& shape) {
  const R3::Box box = Bounds(shape);
  if (IsConvex(shape)) return box.Center();
  R3::Ray ray{box.Center() - 3 * box.Radius() * R3::Vector{1, 0, 0}, {1, 0, 0}};
  const double in = shape.Intersect(ray, 0)->t;
  ray.t_min = in;
  return ray.At((in + shape.Intersect(ray, 0)->t) / 2);
}

}  // namespace crossings
