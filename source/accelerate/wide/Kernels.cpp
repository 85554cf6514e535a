#include "R1/Targets.h"
#include "source/accelerate/wide/Kernels.h"

// Highway compiles this file once per instruction set. Everything independent of that is included before.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "source/accelerate/wide/Kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "source/accelerate/wide/PacketTraversal-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

void ChooseTraversal(Kernels<wide::Tree>* kernels) {
  *kernels = CompiledKernels<wide::Tree>();
  kernels->nearest_packets = &TracePackets<false>;
  kernels->any_packets = &TracePackets<true>;
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ray {
namespace {

HWY_EXPORT(ChooseTraversal);

}  // namespace

void wide::ChooseKernels(void* kernels) {
  HWY_DYNAMIC_DISPATCH(ChooseTraversal)
  (static_cast<Kernels<Tree>*>(kernels));
}

}  // namespace ray
#endif
