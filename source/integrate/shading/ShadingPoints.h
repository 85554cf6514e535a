#pragma once

#include <span>

#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// Completes points whose path and hit are known. The result is that of ShadingPointAt, bit for bit, except for
/// positions, which only recorders show, and texture coordinates if the material does not use them. Loops over arrays
/// compute normals of flat triangles and of spheres, and for all surfaces the sides that face the rays.
///   ray_of   the ray that led to each point
void CompleteShadingPoints(const World& world, std::span<const R3::Ray> rays, std::span<const std::uint32_t> ray_of,
                           std::span<ShadingPoint> points);

}  // namespace ray
