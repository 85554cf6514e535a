#include "R3/Sphere.h"

namespace R3 {

R3_USES_FMA
std::optional<Hit> IntersectSphere(const Ray& ray, const SphereData& sphere) {
  return IntersectSphereInline(ray, sphere, ray.t_min, ray.t_max);
}

R3_USES_FMA
Crossings CrossSphere(const Ray& ray, const SphereData& sphere) {
  if (!(sphere.radius > 0)) return {};
  const auto roots = QuadricRootsInline(ray.origin, ray.direction, sphere.center, sphere.radius);
  return roots ? Span{roots->first, roots->second, 0, 0}.Ends(ray) : Crossings();
}

}  // namespace R3
