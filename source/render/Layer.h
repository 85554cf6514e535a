#pragma once

#include <array>

namespace ray {

/// What an image can hold beside its colors. All but the flare are what is known of the first surface that a camera ray
/// meets, and modes of their names show them alone.
///   depth    distance from the eye to it, in all channels; 0 where there is none
///   normal   its shading normal x y z in the world, on the viewer's side; 0 0 0 where there is none
///   uv       its texture coordinates in the first two channels
///   albedo   what it scatters, kd times texture plus kr plus kt; the background's where there is none
///   id       the number of its primitive in the scene, from 0; -1 where there is none
///   flare    what AddFlare added to the image
enum class Layer { depth, normal, uv, albedo, id, flare };
inline constexpr std::array layer_names{"depth", "normal", "uv", "albedo", "id", "flare"};
constexpr const auto& NamesOf(Layer) { return layer_names; }

}  // namespace ray
