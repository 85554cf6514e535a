#include "source/accelerate/Accelerator.h"
#include "source/accelerate/Nearest.h"

namespace ray {
namespace {

// Asks every primitive: the oracle of all the others, and right for a handful of primitives.
class BruteForce : public Accelerator {
 public:
  explicit BruteForce(const World& world) : world_(world) {}

  std::optional<WorldHit> Intersect(const R3::Ray& ray, Workspace& workspace) const override {
    Nearest nearest(world_, ray);
    LocalRays local(world_, ray);
    for (std::uint32_t i = 0; i < world_.Instances().size(); ++i) {
      const Instance& instance = world_.Instances()[i];
      const int elements = instance.shape->Elements();
      for (int e = 0; e < elements; ++e) nearest.Test(i, e, local.In(instance.frame), workspace.counts);
    }
    return nearest.Best();
  }

  bool IsOccluded(const R3::Ray& ray, Workspace& workspace) const override {
    LocalRays local(world_, ray);
    for (const Instance& instance : world_.Instances()) {
      const int elements = instance.shape->Elements();
      for (int e = 0; e < elements; ++e) {
        ++workspace.counts.primitive_tests;
        if (instance.shape->Intersect(local.In(instance.frame), e)) return true;
      }
    }
    return false;
  }

 private:
  const World& world_;
};

}  // namespace

extern const AcceleratorKind none_kind{
    "none", "every primitive is asked: the oracle of all the others",
    [](const World& world, const AcceleratorSettings&) -> std::unique_ptr<const Accelerator> {
      return std::make_unique<BruteForce>(world);
    }};

}  // namespace ray
