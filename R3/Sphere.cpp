#include "R3/Sphere.h"

namespace R3 {

R3_USES_FMA
std::optional<Hit> IntersectSphere(const Ray& ray, const SphereData& sphere) {
  return IntersectSphereInline(ray, sphere, ray.t_min, ray.t_max);
}

}  // namespace R3
