#include "R3/Triangle.h"

namespace R3 {

std::optional<Hit> IntersectScaledTriangle(const ShearedRay& ray, const double (&x)[3], const double (&y)[3],
                                           const double (&z)[3]) {
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = std::max({size, std::abs(x[i]), std::abs(y[i])});
  if (!(size > 0) || !(size < infinity)) return {};
  const int exponent = std::ilogb(size);
  double a[3], b[3];
  for (std::size_t i = 0; i < 3; ++i) a[i] = std::scalbn(x[i], -exponent), b[i] = std::scalbn(y[i], -exponent);
  const double u = DifferenceOfProducts(a[2], b[1], b[2], a[1]);
  const double v = DifferenceOfProducts(a[0], b[2], b[0], a[2]);
  const double w = DifferenceOfProducts(a[1], b[0], b[1], a[0]);
  if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) return {};
  if (u + v + w == 0) return {};  // edge-on
  return TriangleHit(ray, u, v, w, z);
}

R3_USES_FMA
std::optional<Hit> IntersectTriangle(const ShearedRay& ray, const std::array<Point, 3>& corners) {
  return IntersectTriangleInline(ray, {&corners[0], &corners[1], &corners[2]});
}

}  // namespace R3
