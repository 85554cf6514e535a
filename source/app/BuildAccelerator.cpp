#include "source/app/BuildAccelerator.h"

#include "source/render/Render.h"

namespace ray {

std::unique_ptr<const Accelerator> BuildAccelerator(const World& world, const Options& options) {
  AcceleratorSettings settings = options.accelerator;
  settings.expected_rays = ExpectedRays(options.render);
  return FindAcceleratorKind(settings.name)->Make(world, settings);
}

}  // namespace ray
