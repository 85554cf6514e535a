#pragma once

#include <string>
#include <vector>

#include "source/accelerate/World.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// What -check says of surfaces and solids that touch: surfaces of different materials in one plane where the camera sees
/// them, lights inside of solids, clear meshes with holes, and clear solids that claim the same place without a priority
/// or that a higher priority hides.
std::vector<std::string> ContactMistakes(const World& world, const RenderSettings& settings);

}  // namespace ray
