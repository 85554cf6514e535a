#include "R3/OneSided.h"

namespace R3 {

std::optional<Hit> OneSided::Intersect(const Ray& ray, int element) const {
  Ray rest = ray;
  while (true) {
    const auto hit = shape_.Intersect(rest, element);
    if (!hit || Dot(shape_.At(ray, *hit, element).normal, ray.direction) < 0) return hit;
    rest.t_min = hit->t;
  }
}

}  // namespace R3
