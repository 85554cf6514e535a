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

std::unique_ptr<Accelerator> AcceleratorKind::Make(const World& world, const AcceleratorSettings& settings) const {
  auto accelerator = build(world, settings);
  if (accelerator->kind.empty()) accelerator->kind = name;  // `auto` gives back one of another kind
  return accelerator;
}

const AcceleratorKind* FindAcceleratorKind(const std::string& name) {
  for (const AcceleratorKind* kind : AcceleratorKinds())
    if (name == kind->name) return kind;
  return nullptr;
}

}  // namespace ray
