#include "source/integrate/Modes.h"

#include <algorithm>

#include "source/integrate/FirstHit.h"
#include "source/integrate/Path.h"
#include "source/integrate/Whitted.h"

namespace ray {

std::unique_ptr<const Integrator> MakeIntegrator(const std::string& mode, const World& world,
                                                 const Accelerator& accelerator, const TraceSettings& settings) {
  if (mode == "path") return std::make_unique<Path>(world, accelerator, settings);
  const auto layer = std::find(layer_names.begin(), layer_names.end(), mode);
  if (layer != layer_names.end())
    return std::make_unique<FirstHit>(world, accelerator, static_cast<Layer>(layer - layer_names.begin()));
  return std::make_unique<Whitted>(world, accelerator, settings);
}

}  // namespace ray
