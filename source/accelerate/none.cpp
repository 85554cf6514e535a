#include "source/accelerate/Accelerator.h"
#include "source/accelerate/NearestHit.h"

namespace ray {
namespace {

// Tests every primitive: the oracle of all the others, and right for a handful of primitives.
class BruteForce : public Accelerator {
 public:
  explicit BruteForce(const World& world) : world_(world) {}

 private:
  std::optional<WorldHit> Nearest(const R3::Ray& ray, Workspace& workspace) const override {
    std::optional<WorldHit> best;
    NearestHit nearest(world_, ray, best);
    LocalRays local(world_, ray);
    for (std::uint32_t i = 0; i < world_.Instances().size(); ++i) {
      const Instance& instance = world_.Instances()[i];
      if (!instance.is_bounded) continue;
      const int elements = instance.shape->Elements();
      for (int e = 0; e < elements; ++e) nearest.Test(i, e, local.In(instance.frame), workspace.counts);
    }
    return best;
  }

  bool Any(const R3::Ray& ray, Workspace& workspace) const override {
    LocalRays local(world_, ray);
    for (const Instance& instance : world_.Instances()) {
      if (!instance.is_bounded) continue;
      const int elements = instance.shape->Elements();
      for (int e = 0; e < elements; ++e) {
        if (instance.IsEndOf(ray, e)) continue;
        ++workspace.counts.primitive_tests;
        if (instance.shape->Intersect(local.In(instance.frame), e)) return true;
      }
    }
    return false;
  }

  const World& world_;
};

}  // namespace

extern const AcceleratorKind none_kind{
    "none", "every primitive is tested: the oracle of all the others",
    [](const World& world, const AcceleratorSettings&) -> std::unique_ptr<Accelerator> {
      return std::make_unique<BruteForce>(world);
    }};

}  // namespace ray
