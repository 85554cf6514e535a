#pragma once

#include <span>

#include "source/integrate/ShadingPoint.h"

namespace ray {

/// Of each point, whose path and hit are known, makes the rest: what ShadingPointAt gives, bit for bit, but for texture
/// coordinates where the material has no use for them. Surfaces of flat triangles are made in loops over arrays.
void CompleteShadingPoints(const World& world, std::span<ShadingPoint> points);

}  // namespace ray
