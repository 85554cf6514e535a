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
  const EdgeFunctions edges(a, b);
  if (edges.HaveBothSigns() || edges.Sum() == 0) return {};  // a miss, or edge-on
  return TriangleHit(ray, edges, z);
}

R3_USES_FMA
std::optional<Hit> IntersectTriangle(const ShearedRay& ray, const std::array<Point, 3>& corners) {
  return IntersectTriangleInline(ray, {&corners[0], &corners[1], &corners[2]});
}

}  // namespace R3
