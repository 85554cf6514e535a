#include "source/accelerate/Accelerator.h"
#include "source/accelerate/NearestHit.h"

namespace ray {
namespace {

// Tests every primitive: the oracle of all the others, and right for a handful of primitives.
class BruteForce : public Accelerator {
 public:
  using Accelerator::Accelerator;

 private:
  void Nearest(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const override {
    LocalRays local(world_, ray);
    std::uint32_t i = 0;
    for (const Instance& instance : world_.Instances()) {
      const std::uint32_t number = i++;
      if (!instance.is_bounded || instance.is_repeated) continue;
      const int elements = instance.shape->Elements();
      for (int e = 0; e < elements; ++e) nearest.Test(number, e, local.In(instance.frame), workspace.counts);
    }
  }

  bool Any(const R3::Ray& ray, Workspace& workspace) const override {
    LocalRays local(world_, ray);
    std::uint32_t i = 0;
    for (const Instance& instance : world_.Instances()) {
      const std::uint32_t number = i++;
      if (!instance.is_bounded || instance.is_repeated) continue;
      const int elements = instance.shape->Elements();
      for (int e = 0; e < elements; ++e) {
        const double begin = instance.BeginOf(ray, e);
        if (begin == R3::infinity) continue;
        ++workspace.counts.primitive_tests;
        const R3::Ray& seen = local.In(instance.frame);
        if (begin == ray.t_min && !instance.shape->Intersect(seen, e)) continue;
        if (IsInTheWayFrom(world_, ray, seen, number, e, begin)) return true;
      }
    }
    return false;
  }
};

}  // namespace

extern const AcceleratorKind none_kind{
    "none", "every primitive is tested: the oracle of all the others",
    [](const World& world, const AcceleratorSettings&) -> std::unique_ptr<Accelerator> {
      return std::make_unique<BruteForce>(world);
    }};

}  // namespace ray
