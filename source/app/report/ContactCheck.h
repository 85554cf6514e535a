#pragma once

#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// Returns what every render reports of surfaces that touch: surfaces of different materials in one plane where the
/// camera sees them or one is a lamp, and lights inside of solids. Traces at most 1,152 rays.
std::vector<std::string> PlainContactMistakes(const World& world, const Accelerator& accelerator,
                                              const RenderSettings& settings);

/// Returns what -check reports of surfaces and solids that touch: the same, with 4,224 rays; and clear meshes with
/// holes, and clear solids that claim the same place without a priority or that a higher priority hides.
std::vector<std::string> ContactMistakes(const World& world, const RenderSettings& settings);

}  // namespace ray
