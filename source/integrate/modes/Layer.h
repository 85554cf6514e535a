#pragma once

#include <array>

namespace ray {

/// What is known of the first surface that a camera ray meets.
///   depth    distance from the eye to it, in all channels; 0 where there is none
///   normal   its shading normal x y z in the world, on the viewer's side; 0 0 0 where there is none
///   uv       its texture coordinates in the first two channels
///   albedo   what it scatters, kd times texture plus kr plus kt; the background's where there is none
///   id       the number of its primitive in the scene, from 0; -1 where there is none
enum class Layer { depth, normal, uv, albedo, id };
inline constexpr std::array layer_names{"depth", "normal", "uv", "albedo", "id"};
constexpr const auto& NamesOf(Layer) { return layer_names; }

}  // namespace ray
