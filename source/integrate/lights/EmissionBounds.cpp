#include "source/integrate/lights/EmissionBounds.h"

#include <algorithm>

#include "source/accelerate/BoundsPadding.h"

namespace ray {

EmissionBounds::EmissionBounds(const World& world) {
  for (const Instance& instance : world.Instances()) {
    if (!instance.Emits()) continue;
    is_unbounded_ |= !instance.is_bounded;
    for (int i = 0; i < instance.shape->Elements(); ++i) {
      const R3::Box box = world.InWorld(instance.frame, instance.shape->Bounds(i));
      const NodeBoundsPadding padding = WorldBoundsPadding(world.Frames()[instance.frame], Reach(box));
      const R3::Vector margin{padding.constant, padding.constant, padding.constant};
      const R3::Box widened{box.low - margin, box.high + margin};
      is_unbounded_ |= !IsFinite(FromOrigin(widened.low)) || !IsFinite(FromOrigin(widened.high));
      box_.Extend(widened);
      padding_per_distance_ = std::max(padding_per_distance_, padding.per_distance);
    }
  }
}

bool EmissionBounds::MayBeHitBy(const R3::Ray& ray) const {
  if (is_unbounded_) return true;
  const double distance = MaxComponent(Abs(FromOrigin(ray.origin)));
  return Entry(box_, R3::BoxRay(ray), padding_per_distance_ * distance).has_value();
}

}  // namespace ray
