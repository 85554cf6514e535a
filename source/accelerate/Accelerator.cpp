#include "source/accelerate/Accelerator.h"

#include <array>

namespace ray {

#define ACCELERATOR(name) extern const AcceleratorKind name##_kind;
#include "source/accelerate/accelerators.def"
#undef ACCELERATOR

std::span<const AcceleratorKind* const> AcceleratorKinds() {
  static const std::array kinds{
#define ACCELERATOR(name) &name##_kind,
#include "source/accelerate/accelerators.def"
#undef ACCELERATOR
  };
  return kinds;
}

const AcceleratorKind* FindAcceleratorKind(const std::string& name) {
  for (const AcceleratorKind* kind : AcceleratorKinds())
    if (name == kind->name) return kind;
  return nullptr;
}

}  // namespace ray
