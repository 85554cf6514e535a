#include "source/accelerate/Accelerator.h"

#include <array>

#include "R1/Kinds.h"
#include "source/accelerate/NearestHit.h"

namespace ray {

std::span<const AcceleratorKind* const> AcceleratorKinds() {
#define ACCELERATOR(name) KIND(AcceleratorKind, name##_kind),
  static const std::array kinds{
#include "source/accelerate/accelerators.def"
  };
  return kinds;
}

void Accelerator::TestUnbounded(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const {
  LocalRays local(world_, ray);
  for (const std::uint32_t instance : world_.Unbounded())
    nearest.Test(instance, 0, local.In(world_.Instances()[instance].frame), workspace.counts);
}

void Accelerator::OfferUnbounded(const R3::Ray& ray, std::optional<WorldHit>& hit, Workspace& workspace) const {
  std::optional<WorldHit> best;
  NearestHit nearest(world_, ray, best);
  if (hit) nearest.Offer(*hit);
  TestUnbounded(ray, nearest, workspace);
  hit = best;
}

bool Accelerator::IsBehindUnbounded(const R3::Ray& ray, Workspace& workspace) const {
  LocalRays local(world_, ray);
  for (const std::uint32_t instance : world_.Unbounded())
    if (IsInTheWay(world_, ray, local.In(world_.Instances()[instance].frame), instance, 0, workspace.counts))
      return true;
  return false;
}

std::vector<WorldHit> Accelerator::HitsNear(const R3::Ray& ray, const WorldHit& nearest, Workspace& workspace) const {
  R3::Ray near = ray;
  near.t_max = std::min(ray.t_max, EndOfCoincidence(world_, nearest.t));
  std::vector<WorldHit> hits{nearest};  // found again, unless t is so small that no larger t is nearby
  std::optional<WorldHit> none;
  NearestHit all(world_, near, none, hits);
  Search(near, all, workspace);
  return hits;
}

WorldHit Accelerator::Seen(const R3::Ray& ray, const WorldHit& nearest, Workspace& workspace) const {
  WorldHit seen = SeenOf(world_, ray, HitsNear(ray, nearest, workspace));
  seen.is_contested = true;  // those found near it are not marked
  return seen;
}

std::vector<WorldHit> Accelerator::Coincident(const R3::Ray& ray, const WorldHit& hit, Workspace& workspace) const {
  return CoincidentOf(world_, ray, HitsNear(ray, hit, workspace));
}

std::unique_ptr<Accelerator> AcceleratorKind::Make(const World& world, const AcceleratorSettings& settings) const {
  auto accelerator = build(world, settings);
  if (accelerator->kind.empty()) accelerator->kind = name;  // `auto` returns one of another kind
  return accelerator;
}

const AcceleratorKind* FindAcceleratorKind(const std::string& name) { return R1::FindKind(AcceleratorKinds(), name); }

}  // namespace ray
