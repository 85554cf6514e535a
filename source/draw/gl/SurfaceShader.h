#pragma once

#include <string>

namespace ray {

/// The features of a scene that the shader of its surfaces must support. Others are not compiled, since a software
/// renderer runs both sides of each branch.
struct SurfaceFeatures {
  bool textures = false, environment = false, mirrors = false, shadows = false;
  friend bool operator==(const SurfaceFeatures&, const SurfaceFeatures&) = default;
};

/// Return the shaders of surfaces, and of the environment behind them, in GLSL 330.
std::string SurfaceVertexShader();
std::string SurfaceFragmentShader(const SurfaceFeatures& features);
/// Return the shaders of shadow maps, which write only depth.
std::string DepthVertexShader();
std::string DepthFragmentShader();
std::string SkyVertexShader();
std::string SkyFragmentShader();

}  // namespace ray
