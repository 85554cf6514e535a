#include "R3/Box.h"

namespace R3 {

Point Box::Center() const { return {low.x / 2 + high.x / 2, low.y / 2 + high.y / 2, low.z / 2 + high.z / 2}; }

double Box::Radius() const { return IsEmpty() ? 0 : Length(Size()) / 2; }

void Box::Extend(const Point& p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

void Box::Extend(const Box& b) {
  if (b.IsEmpty()) return;
  Extend(b.low);
  Extend(b.high);
}

BoxRay::BoxRay(const Ray& ray)
    : origin(ray.origin),
      inverse{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z},
      t_min(ray.t_min),
      t_max(ray.t_max) {}

}  // namespace R3
