#pragma once

#include <span>

#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// Completes points whose path and hit are known: to what ShadingPointAt gives, bit for bit, but for positions, which
/// recorders alone show, and texture coordinates where the material has no use for them. What can be is made in loops
/// over arrays: normals of flat triangles and of spheres, and of all surfaces the sides they turn to the rays.
///   ray_of   which of the rays led to each point
void CompleteShadingPoints(const World& world, std::span<const R3::Ray> rays, std::span<const std::uint32_t> ray_of,
                           std::span<ShadingPoint> points);

}  // namespace ray
