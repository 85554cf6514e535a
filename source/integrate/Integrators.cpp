#include "source/integrate/Integrators.h"

#include "source/integrate/modes/Outlined.h"

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

std::unique_ptr<const Integrator> MakeIntegrator(RenderMode mode, const World& world, const Accelerator& accelerator,
                                                 const TraceSettings& settings) {
  auto plain = KindOf(mode).make(world, accelerator, settings);
  return settings.outline.width > 0 ? WithOutlines(std::move(plain), world, accelerator, settings.outline)
                                    : std::move(plain);
}

}  // namespace ray
