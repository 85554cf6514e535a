#include "source/integrate/Modes.h"

#include "source/integrate/FirstHit.h"
#include "source/integrate/Path.h"
#include "source/integrate/Whitted.h"
#include "source/text/EnumNames.h"

namespace ray {

std::unique_ptr<const Integrator> MakeIntegrator(RenderMode mode, const World& world, const Accelerator& accelerator,
                                                 const TraceSettings& settings) {
  if (mode == RenderMode::path) return std::make_unique<Path>(world, accelerator, settings);
  if (const auto layer = Named<Layer>(NameOf(mode))) return std::make_unique<FirstHit>(world, accelerator, *layer);
  return std::make_unique<Whitted>(world, accelerator, settings);
}

}  // namespace ray
