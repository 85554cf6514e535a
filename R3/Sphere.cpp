#include "R3/Sphere.h"

namespace R3 {

R3_USES_FMA
std::optional<Hit> IntersectSphere(const Ray& ray, const SphereData& sphere, double t_max) {
  return IntersectSphereInline(ray, sphere, t_max);
}

}  // namespace R3
