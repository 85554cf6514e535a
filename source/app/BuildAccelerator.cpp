#include "source/app/BuildAccelerator.h"

#include "source/render/RenderInputs.h"

namespace ray {

std::unique_ptr<const Accelerator> BuildAccelerator(const World& world, AcceleratorSettings settings,
                                                    const RenderSettings& render) {
  settings.expected_rays = ExpectedRays(render);
  return FindAcceleratorKind(settings.name)->Make(world, settings);
}

}  // namespace ray
