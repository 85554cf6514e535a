#pragma once

#include <string>
#include <vector>

#include "source/accelerate/World.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// What rendering a scene with some settings takes, found once before the first ray. Features that are stated but have
/// no effect (an aperture of 0, equal poses, a kt of 0 on everything that is used, black lights) do not count.
struct SceneFeatures {
  bool motion = false, lens = false;
  const char* projection = "pinhole";
  bool lights = false, area_lights = false, emissive_triangles = false, emissive_shapes = false, environment = false,
       choice_of_lights = false;
  bool mirrors = false, clear = false, bending = false, absorbing = false, textures = false, shadow_bias = false;
  bool wide_filter = false, two_streams = false;

  /// Names of the features that the image has.
  std::vector<std::string> Names() const;
};

/// The lights that the scene names and that shine in the mode of the render, none of them black.
std::vector<const Light*> ShiningLights(const World& world, const RenderSettings& settings);

SceneFeatures FeaturesOf(const World& world, const RenderSettings& settings);

/// Which variant of the innermost loops runs: "whitted, pinhole, box filter".
std::string KernelName(const SceneFeatures& features, const RenderSettings& settings);

/// The settings in force that move the mean of the picture away from that of its mode without limits: "max_depth 3".
std::vector<std::string> SourcesOfBias(const SceneFeatures& features, const RenderSettings& settings);

/// The settings in force for which the pixels of a crop are not those of the whole: they decide by all that is
/// rendered, or by the clock. "error 2". None where all is rendered.
std::vector<std::string> CropDifferences(const RenderSettings& settings);

}  // namespace ray
