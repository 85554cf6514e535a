#include <algorithm>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/bvh/Build.h"
#include "source/accelerate/bvh/Kernels.h"

namespace ray {
namespace {

// A wide tree of boxes, its nodes and triangles tested eight at a time: see bvh/.
class WideBvh : public Accelerator {
 public:
  WideBvh(const World& world, const AcceleratorSettings& settings)
      : world_(world), kernels_(bvh::ChooseKernels(settings.instruction_set)) {
    forest_.world = &world;
    bvh::BuildSettings build;
    if (settings.resolution > 0) build.leaf_size = std::clamp(static_cast<int>(settings.resolution), 1, bvh::width);
    build.cuts_large_triangles = settings.quality == "high";
    forest_.trees.push_back(bvh::Build(world, Space(world), build));
    for (int i = 0; i < static_cast<int>(world.SharedMeshes().size()); ++i)
      forest_.trees.push_back(bvh::Build(world, Space(world, i), build));
  }

  std::size_t Bytes() const override { return forest_.Bytes(); }

  std::vector<std::string> Explain() const override {
    std::vector<std::string> lines{"bvh walks with " + std::string(kernels_.name)};
    for (std::size_t i = 0; i < forest_.trees.size(); ++i) {
      const bvh::Tree& tree = forest_.trees[i];
      lines.push_back((i == 0 ? std::string("the world") : "shared mesh " + std::to_string(i)) + ": " +
                      std::to_string(tree.space.Items()) + " items, " + std::to_string(tree.nodes) +
                      " nodes in " + std::to_string(tree.depth) + " levels, " + std::to_string(tree.blocks) +
                      " blocks of triangles, " + std::to_string(tree.Bytes()) + " bytes");
    }
    return lines;
  }

 private:
  std::optional<WorldHit> Nearest(const R3::Ray& ray, Workspace& workspace) const override {
    NearestHit nearest(world_, ray);
    kernels_.nearest(forest_, ray, nearest, workspace.counts);
    return nearest.Best();
  }

  bool Any(const R3::Ray& ray, Workspace& workspace) const override {
    return kernels_.any(forest_, ray, workspace.counts);
  }

  const World& world_;
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
