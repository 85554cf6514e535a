#pragma once

#include <array>

#include "R2/Image.h"
#include "source/integrate/Integrators.h"

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

/// Returns an image of that mode converted to the range 0..1 of a screen: depth from white, the nearest, to black;
/// normals as (N + 1) / 2; a different color for each id. Images of other modes are unchanged.
R2::Image LayerAsShown(RenderMode mode, const R2::Image& image);
/// Returns true if the conversion changes nothing, so that large images need not be copied.
bool IsShownAsItIs(RenderMode mode);

}  // namespace ray
