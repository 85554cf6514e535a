#include "source/accelerate/Accelerator.h"
#include "source/accelerate/NearestHit.h"

namespace ray {
namespace {

// Tests every primitive: the oracle for all other accelerators, and the best choice for a handful of primitives.
class BruteForce : public Accelerator {
 public:
  using Accelerator::Accelerator;

 private:
  void Nearest(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const override {
    ForEachUntil(ray, [&](std::uint32_t instance, int element, const R3::Ray& local) {
      nearest.Test(instance, element, local, workspace.counts);
      return false;
    });
  }

  bool Any(const R3::Ray& ray, Workspace& workspace) const override {
    return ForEachUntil(ray, [&](std::uint32_t instance, int element, const R3::Ray& local) {
      return IsInTheWay(world_, ray, local, instance, element, workspace.counts);
    });
  }

  /// Tests all elements until one ends the search; returns true if one did.
  template <typename Test>
  bool ForEachUntil(const R3::Ray& ray, const Test& ends) const {
    LocalRays local(world_, ray);
    for (std::uint32_t i = 0; i < world_.Instances().size(); ++i) {
      const Instance& instance = world_.Instances()[i];
      if (!instance.is_bounded || instance.is_repeated) continue;
      const int elements = instance.shape->Elements();
      for (int e = 0; e < elements; ++e)
        if (ends(i, e, local.In(instance.frame))) return true;
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
