#include <algorithm>

#include "source/accelerate/wide/Build.h"
#include "source/accelerate/wide/Kernels.h"

namespace ray {

extern const AcceleratorKind bvh_kind{
    "bvh", "a wide tree of boxes, eight at a time: the fastest for most scenes",
    [](const World& world, const AcceleratorSettings& settings) -> std::unique_ptr<Accelerator> {
      const int leaf_size =
          settings.resolution > 0 ? std::clamp(static_cast<int>(settings.resolution), 1, width) : width;
      return std::make_unique<TwoLevelAccelerator<wide::Tree>>(
          world, settings, wide::ChooseKernels,
          [&](PrimitiveSet primitives) { return wide::Build(std::move(primitives), leaf_size); });
    }};

}  // namespace ray
