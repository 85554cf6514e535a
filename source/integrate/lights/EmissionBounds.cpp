#include "source/integrate/lights/EmissionBounds.h"

#include <algorithm>

#include "R3/shapes/Span.h"
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
  const double padding = padding_per_distance_ * MaxComponent(Abs(FromOrigin(ray.origin)));
  const R3::Vector margin{padding, padding, padding};
  // Most rays leave the box, and a division takes longer.
  if (R3::IsLeavingBox({box_.low - margin, box_.high + margin}, ray)) return false;
  return Entry(box_, R3::BoxRay(ray), padding).has_value();
}

}  // namespace ray
