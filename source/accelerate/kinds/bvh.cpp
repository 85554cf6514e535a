#include <algorithm>

#include "source/accelerate/Forest.h"
#include "source/accelerate/bvh/Build.h"

// Highway compiles this file once for each instruction set. What does not depend on that is included before.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "source/accelerate/kinds/bvh.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "source/accelerate/bvh/Packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

void ChooseBvh(Kernels<bvh::Tree>* kernels) {
  *kernels = CompiledKernels<bvh::Tree>();
  kernels->nearest_together = &FindTogether<false>;
  kernels->any_together = &FindTogether<true>;
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ray {
namespace {

HWY_EXPORT(ChooseBvh);

}  // namespace

extern const AcceleratorKind bvh_kind{
    "bvh", "a wide tree of boxes, eight at a time: the fastest for most scenes",
    [](const World& world, const AcceleratorSettings& settings) -> std::unique_ptr<const Accelerator> {
      bvh::BuildSettings build;
      if (settings.resolution > 0) build.leaf_size = std::clamp(static_cast<int>(settings.resolution), 1, width);
      build.cuts_large_triangles = settings.quality == "high";
      return std::make_unique<ForestAccelerator<bvh::Tree>>(
          world, settings,
          [](void* kernels) {
            HWY_DYNAMIC_DISPATCH(ChooseBvh)
            (static_cast<Kernels<bvh::Tree>*>(kernels));
          },
          [&](Space space) { return bvh::Build(std::move(space), build); });
    }};

}  // namespace ray
#endif
