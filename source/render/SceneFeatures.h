#pragma once

#include <string>
#include <vector>

#include "source/accelerate/World.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// The features of a scene and its settings that affect the render, found once before the first ray. Features without
/// an effect do not count: an aperture of 0, equal poses, a kt of 0 on all used materials, black lights.
struct SceneFeatures {
  bool motion = false, lens = false;
  const char* projection = "pinhole";
  bool lights = false, area_lights = false, emissive_triangles = false, emissive_shapes = false, environment = false,
       choice_of_lights = false;
  bool mirrors = false, clear = false, bending = false, absorbing = false, textures = false, shadow_bias = false;
  bool wide_filter = false, two_streams = false, shared_light = false;

  /// Returns the names of the features.
  std::vector<std::string> Names() const;
};

/// Returns the lights of the scene that shine in the mode of the render and are not black.
std::vector<const Light*> ShiningLights(const World& world, const RenderSettings& settings);

SceneFeatures FeaturesOf(const World& world, const RenderSettings& settings);

/// Returns the variant of the innermost loops that runs: "whitted, pinhole, box filter".
std::string KernelName(const SceneFeatures& features, const RenderSettings& settings);

/// Returns the effective settings that change the mean of the image from that of its mode without limits: "max_depth
/// 3".
std::vector<std::string> SourcesOfBias(const SceneFeatures& features, const RenderSettings& settings);
/// Returns true for one of them that cuts light off, "max_depth 3" or "min_luminance 0.01".
bool CutsLight(const std::string& source);

/// Returns the effective settings for which the pixels of a crop differ from those of the whole image, since they
/// decide by the whole rendered region or by the clock: "error 2". Empty if the whole image is rendered.
std::vector<std::string> CropDifferences(const RenderSettings& settings);

}  // namespace ray
