#include "source/accelerate/Accelerator.h"

#include <array>

#include "source/accelerate/NearestHit.h"

namespace ray {

#define ACCELERATOR(name) extern const AcceleratorKind name##_kind;
#include "source/accelerate/accelerators.def"
#undef ACCELERATOR

std::span<const AcceleratorKind* const> AcceleratorKinds() {
  static const std::array kinds{
#define ACCELERATOR(name) &name##_kind,
#include "source/accelerate/accelerators.def"
#undef ACCELERATOR
  };
  return kinds;
}

void Accelerator::OfferUnbounded(const R3::Ray& ray, std::optional<WorldHit>& hit, Workspace& workspace) const {
  std::optional<WorldHit> best;
  NearestHit nearest(*unbounded_, ray, best);
  if (hit) nearest.Offer(*hit);
  LocalRays local(*unbounded_, ray);
  for (const std::uint32_t instance : unbounded_->Unbounded())
    nearest.Test(instance, 0, local.In(unbounded_->Instances()[instance].frame), workspace.counts);
  hit = best;
}

bool Accelerator::IsBehindUnbounded(const R3::Ray& ray, Workspace& workspace) const {
  LocalRays local(*unbounded_, ray);
  for (const std::uint32_t index : unbounded_->Unbounded()) {
    const Instance& instance = unbounded_->Instances()[index];
    if (instance.IsEndOf(ray, 0)) continue;
    ++workspace.counts.primitive_tests;
    if (instance.shape->Intersect(local.In(instance.frame), 0)) return true;
  }
  return false;
}

std::unique_ptr<Accelerator> AcceleratorKind::Make(const World& world, const AcceleratorSettings& settings) const {
  auto accelerator = build(world, settings);
  if (!world.Unbounded().empty()) accelerator->unbounded_ = &world;
  if (accelerator->kind.empty()) accelerator->kind = name;  // `auto` gives back one of another kind
  return accelerator;
}

const AcceleratorKind* FindAcceleratorKind(const std::string& name) {
  for (const AcceleratorKind* kind : AcceleratorKinds())
    if (name == kind->name) return kind;
  return nullptr;
}

}  // namespace ray
