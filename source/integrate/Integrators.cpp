#include "source/integrate/Integrators.h"

namespace ray {

#define INTEGRATOR(name) extern const IntegratorKind name##_kind;
#include "source/integrate/integrators.def"
#undef INTEGRATOR

std::span<const IntegratorKind* const> IntegratorKinds() {
  static const std::array kinds{
#define INTEGRATOR(name) &name##_kind,
#include "source/integrate/integrators.def"
#undef INTEGRATOR
  };
  return kinds;
}

const IntegratorKind& KindOf(RenderMode mode) { return *IntegratorKinds()[static_cast<std::size_t>(mode)]; }

}  // namespace ray
