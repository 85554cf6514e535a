#include "R3/Triangle.h"

namespace R3 {

R3_USES_FMA
std::optional<Hit> IntersectTriangle(const ShearedRay& ray, const std::array<Point, 3>& corners) {
  return IntersectTriangleInline(ray, corners);
}

}  // namespace R3
