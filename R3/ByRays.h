#pragma once

#include "R3/Shape.h"
#include "R3/UvTangents.h"

namespace R3 {

/// Returns triangles for a shape that is known only by its ray intersections, with the guarantees of Shape::Tessellate.
///   triangles  the approximate number; parts thinner than the width of the triangles may be lost
///   source     for solids Gibson, Constrained elastic surface nets (1998), with a ray in place of her relaxation: one
///              corner in each cell that the surface passes through, four of them joined across each edge of the grid
///              that it crosses
MeshData TessellateByRays(const Shape& shape, int triangles);

/// Returns the tangents of Shape::UvTangentsAt for a shape that is known only by its ray intersections: compares the
/// texture coordinates of rays that hit it close to the given hit.
///   accuracy   with steps of 2^-15 of the shape's size to both sides, truncation leaves about 2^-30 of the gains of u
///              and v
///              on a surface that curves no more than its size implies, and rounding 2^-35 near the origin, or 2^-15 a
///              million sizes away from it; if one side has no hit, as at an edge, truncation leaves 2^-15
UvTangents UvTangentsByRays(const Shape& shape, const Ray& ray, const Hit& hit, int element);

}  // namespace R3
