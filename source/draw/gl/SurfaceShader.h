#pragma once

#include <string>

#include "source/integrate/Integrators.h"

namespace ray {

/// What a scene asks of the shader of its surfaces; what it does not ask for is not compiled.
struct SurfaceFeatures {
  bool textures = false, vertex_colors = false, bumps = false, normal_maps = false, specular_maps = false,
       environment = false, diffuse_light = false, clear = false, coats = false, fresnel = false, shadows = false,
       discs = false, mirrors = true, probes = false;
  RenderMode mode = RenderMode::whitted;  // path and those that are not previewed are whitted
  friend bool operator==(const SurfaceFeatures&, const SurfaceFeatures&) = default;
};

/// The shaders of surfaces, and of the environment behind them, in GLSL 330.
std::string SurfaceVertexShader();
std::string SurfaceFragmentShader(const SurfaceFeatures& features);
/// For shadow maps: nothing but depth.
std::string DepthVertexShader();
std::string DepthFragmentShader();
std::string SkyVertexShader();
std::string SkyFragmentShader();

}  // namespace ray
