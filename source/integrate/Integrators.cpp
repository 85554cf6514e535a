#include "source/integrate/Integrators.h"

#include "R1/Kinds.h"
#include "source/integrate/modes/Outlined.h"

namespace ray {

std::span<const IntegratorKind* const> IntegratorKinds() {
#define INTEGRATOR(name) KIND(IntegratorKind, name##_kind),
  static const std::array kinds{
#include "source/integrate/integrators.def"
  };
  return kinds;
}

const IntegratorKind& KindOf(RenderMode mode) { return *IntegratorKinds()[static_cast<std::size_t>(mode)]; }

std::unique_ptr<const Integrator> MakeIntegrator(RenderMode mode, const World& world, const Accelerator& accelerator,
                                                 const TraceSettings& settings) {
  auto plain = KindOf(mode).make(world, accelerator, settings);
  return settings.outline.width > 0 ? WithOutlines(std::move(plain), world, accelerator, settings.outline)
                                    : std::move(plain);
}

}  // namespace ray
