#pragma once

#include <string>

namespace ray {

/// What a scene asks of the shader of its surfaces; what it does not ask for is not compiled, since a renderer in
/// software runs both sides of each branch.
struct SurfaceFeatures {
  bool textures = false, environment = false, mirrors = false, shadows = false;
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
