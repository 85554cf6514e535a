#pragma once

#include <array>

namespace ray {

/// Additional layers of an image. All except the flare show properties of the first surface that a camera ray hits; the
/// modes with the same names show these alone.
///   depth    distance from the eye to the surface, in all channels; 0 without a surface
///   normal   its shading normal x y z in the world, on the viewer's side; 0 0 0 without a surface
///   uv       its texture coordinates in the first two channels
///   albedo   its reflectance, kd times texture plus kr plus kt; the background's color without a surface
///   id       the number of its primitive in the scene, 0-based; -1 without a surface
///   flare    the light that AddFlare added to the image
enum class Layer { depth, normal, uv, albedo, id, flare };
inline constexpr std::array layer_names{"depth", "normal", "uv", "albedo", "id", "flare"};
constexpr const auto& NamesOf(Layer) { return layer_names; }

}  // namespace ray
