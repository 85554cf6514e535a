#pragma once

#include "source/integrate/Integrator.h"

namespace ray {

/// Draws black lines over the image of another integrator, along silhouettes and creases: where depth or normals jump
/// between the places half a line's width to the left and right, or below and above. They are found for each camera ray
/// by additional rays next to it, so that more samples smooth them, and lines are as wide in a crop as in the whole
/// image.
///   source   Saito, Takahashi, Comprehensible rendering of 3-D shapes (1990), for edges from images of depth and
///            normals
std::unique_ptr<const Integrator> WithOutlines(std::unique_ptr<const Integrator> inner, const World& world,
                                               const Accelerator& accelerator, const OutlineSettings& outline);

}  // namespace ray
