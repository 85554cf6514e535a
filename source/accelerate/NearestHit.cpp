#include "source/accelerate/NearestHit.h"

namespace ray {

std::optional<R3::Hit> FirstAhead(const World& world, const R3::Ray& ray, const R3::Ray& local, std::uint32_t instance,
                                  int element, double begin) {
  R3::Ray rest = local;
  rest.t_min = begin;
  while (true) {
    const auto hit = world.Instances()[instance].shape->Intersect(rest, element);
    if (!hit || !IsNearStart(ray, hit->t) || IsAhead(world, ray, {*hit, instance, element})) return hit;
    rest.t_min = hit->t;
  }
}

bool IsInTheWayFrom(const World& world, const R3::Ray& ray, const R3::Ray& local, std::uint32_t instance, int element,
                    double begin) {
  const auto hit = FirstAhead(world, ray, local, instance, element, begin);
  return hit && IsInTheWay(world, ray, {*hit, instance, element});
}

}  // namespace ray
