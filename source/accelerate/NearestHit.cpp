#include "source/accelerate/NearestHit.h"

namespace ray {

std::optional<R3::Hit> FirstAhead(const World& world, const R3::Ray& ray, const R3::Ray& local, std::uint32_t instance,
                                  int element, double begin) {
  R3::Ray rest = local;
  rest.t_min = begin;
  const auto hit = world.Instances()[instance].shape->Intersect(rest, element);
  if (!hit || !IsNearStart(ray, hit->t)) return hit;
  return FirstAheadFrom(world, ray, local, instance, element, *hit);
}

std::optional<R3::Hit> FirstAheadFrom(const World& world, const R3::Ray& ray, const R3::Ray& local,
                                      std::uint32_t instance, int element, const R3::Hit& near_start) {
  R3::Ray rest = local;
  std::optional hit = near_start;
  while (hit && IsNearStart(ray, hit->t) && !IsAhead(world, ray, {*hit, instance, element})) {
    rest.t_min = hit->t;
    hit = world.Instances()[instance].shape->Intersect(rest, element);
  }
  return hit;
}

bool IsInTheWayAt(const World& world, const R3::Ray& ray, const R3::Ray& local, std::uint32_t instance, int element,
                  const R3::Hit& hit) {
  if (!IsNearStart(ray, hit.t)) return IsInTheWay(world, ray, {hit, instance, element});
  const auto ahead = FirstAheadFrom(world, ray, local, instance, element, hit);
  return ahead && IsInTheWay(world, ray, {*ahead, instance, element});
}

bool IsInTheWayFrom(const World& world, const R3::Ray& ray, const R3::Ray& local, std::uint32_t instance, int element,
                    double begin) {
  const auto hit = FirstAhead(world, ray, local, instance, element, begin);
  return hit && IsInTheWay(world, ray, {*hit, instance, element});
}

}  // namespace ray
