#include "R3/Triangle.h"

namespace R3 {

ShearedRay::ShearedRay(const Ray& ray) : origin(ray.origin), t_min(ray.t_min), t_max(ray.t_max) {
  z_axis = MaxAxis(ray.direction);
  x_axis = (z_axis + 1) % 3;
  y_axis = (z_axis + 2) % 3;
  z_scale = 1 / ray.direction[z_axis];
  x_shear = ray.direction[x_axis] * z_scale;
  y_shear = ray.direction[y_axis] * z_scale;
}

R3_USES_FMA
std::optional<Hit> IntersectTriangle(const ShearedRay& ray, const std::array<Point, 3>& corners) {
  double x[3], y[3], z[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector v = corners[i] - ray.origin;
    z[i] = v[ray.z_axis];
    x[i] = v[ray.x_axis] - ray.x_shear * z[i];
    y[i] = v[ray.y_axis] - ray.y_shear * z[i];
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

}  // namespace R3
