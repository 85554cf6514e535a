#pragma once

#include "R3/Shape.h"

namespace R3 {

/// Returns triangles for a shape that is known only by its ray intersections, with the guarantees of Shape::Tessellate.
///   triangles  the approximate number; parts thinner than the width of the triangles may be lost
///   source     for solids Gibson, Constrained elastic surface nets (1998), with a ray in place of her relaxation: one
///              corner in each cell that the surface passes through, four of them joined across each edge of the grid
///              that it crosses
MeshData TessellateByRays(const Shape& shape, int triangles);

}  // namespace R3
