#pragma once

#include "R3/Shape.h"

namespace R3 {

/// Triangles for a shape of which nothing is known but what rays find, with the promises of Shape::Tessellate.
///   triangles  about how many; parts that are thinner than the triangles are wide may be lost
///   source     for solids Gibson, Constrained elastic surface nets (1998), with a ray in place of her relaxation: one
///             corner in each cell that the surface passes through, four of them joined across each edge of the grid
///             that it crosses
MeshData TessellateByRays(const Shape& shape, int triangles);

}  // namespace R3
