#pragma once

#include <string>
#include <vector>

#include "source/accelerate/World.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// True if LampMistakes takes no more than some milliseconds.
bool HasFewLamps(const World& world);

/// What -check says of shapes that emit: meshes that mode whitted takes for many lamps, and scenes of which the modes
/// whitted and path, which read emission differently, make pictures of very different light.
std::vector<std::string> LampMistakes(const World& world, const RenderSettings& settings);

}  // namespace ray
