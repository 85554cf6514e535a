#pragma once

#include <memory>

#include "source/accelerate/Accelerator.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// The accelerator of these settings, built for about as many rays as the render will trace.
std::unique_ptr<const Accelerator> BuildAccelerator(const World& world, AcceleratorSettings settings,
                                                    const RenderSettings& render);

}  // namespace ray
