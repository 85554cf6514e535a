#pragma once

#include <string>
#include <vector>

#include "source/accelerate/World.h"
#include "source/app/options/Options.h"

namespace ray {

/// What -check prints: what is in the scene, and how much memory it and its picture take.
std::string SceneSummary(const World& world, const RenderSettings& settings);

/// What its author may not have meant: a camera inside something, no light, shapes that cannot be seen...
std::vector<std::string> LikelyMistakes(const World& world, const RenderSettings& settings);

/// How many of the solids and meshes hold the point inside: a ray from it crosses their surface an odd number of times.
/// A mesh counts only if three rays agree, for it may be open.
int SolidsAround(const World& world, const R3::Point& point);

}  // namespace ray
