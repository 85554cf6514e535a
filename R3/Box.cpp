#include "R3/Box.h"

namespace R3 {

Point Box::Center() const { return {low.x / 2 + high.x / 2, low.y / 2 + high.y / 2, low.z / 2 + high.z / 2}; }

double Box::Radius() const { return IsEmpty() ? 0 : Length(Size()) / 2; }

BoxRay::BoxRay(const Ray& ray)
    : origin(ray.origin),
      inverse{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z},
      t_min(ray.t_min),
      t_max(ray.t_max) {}

}  // namespace R3
