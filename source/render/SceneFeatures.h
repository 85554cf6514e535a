#pragma once

#include <string>
#include <vector>

#include "source/accelerate/World.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// What a scene and the settings of a picture ask for, found once before the first ray. Things that are stated but have
/// no effect (an aperture of 0, equal poses, a kt of 0 on everything that is used, black lights) are not asked for.
struct SceneFeatures {
  bool motion = false, lens = false;
  bool lights = false, area_lights = false, emissive_triangles = false, environment = false, choice_of_lights = false;
  bool mirrors = false, clear = false, bending = false, absorbing = false, textures = false;
  bool wide_filter = false, two_streams = false;

  /// The names of those that are asked for.
  std::vector<std::string> Names() const;
};

SceneFeatures FeaturesOf(const World& world, const RenderSettings& settings);

/// What runs in the innermost loops: "whitted, pinhole, box filter".
std::string KernelOf(const SceneFeatures& needs, const RenderSettings& settings);

/// Settings in force that move the picture's mean away from the truth of the mode, each in a few words.
std::vector<std::string> BiasedSettings(const SceneFeatures& needs, const RenderSettings& settings);

}  // namespace ray
