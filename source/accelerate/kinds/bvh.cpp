#include "source/accelerate/Accelerator.h"
#include "source/accelerate/bvh/Build.h"
#include "source/accelerate/bvh/Kernels.h"

namespace ray {
namespace {

// A wide tree of boxes, its nodes and triangles tested eight at a time: see bvh/.
class WideBvh : public Accelerator {
 public:
  WideBvh(const World& world, const AcceleratorSettings& settings)
      : world_(world), settings_(settings), kernels_(bvh::ChooseKernels(settings.instruction_set)) {
    forest_.world = &world;
    forest_.trees.push_back(bvh::Build(world, Space(world), {}));
    for (int i = 0; i < static_cast<int>(world.SharedMeshes().size()); ++i)
      forest_.trees.push_back(bvh::Build(world, Space(world, i), {}));
  }

  std::size_t Bytes() const override { return forest_.Bytes(); }

 private:
  std::optional<WorldHit> Nearest(const R3::Ray& ray, Workspace& workspace) const override {
    NearestHit nearest(world_, ray);
    kernels_.nearest(forest_, ray, nearest, workspace.counts);
    return nearest.Best();
  }

  bool Any(const R3::Ray& ray, Workspace& workspace) const override {
    NearestHit nearest(world_, ray);
    kernels_.any(forest_, ray, nearest, workspace.counts);
    return nearest.Best().has_value();
  }

  const World& world_;
  AcceleratorSettings settings_;
  const bvh::Kernels& kernels_;
  bvh::Forest forest_;
};

}  // namespace

extern const AcceleratorKind bvh_kind{
    "bvh", "a wide tree of boxes, eight at a time: the fastest for most scenes",
    [](const World& world, const AcceleratorSettings& settings) -> std::unique_ptr<const Accelerator> {
      return std::make_unique<WideBvh>(world, settings);
    }};

}  // namespace ray
