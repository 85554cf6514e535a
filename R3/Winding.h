#pragma once

#include <cstdint>
#include <vector>

#include "R3/MeshData.h"

namespace R3 {

/// The triangles, in ascending order, whose corners turn clockwise as seen from the side that the vertex normals of
/// their surface point to. Exporters that mirror a model leave such triangles behind.
///
/// A single triangle does not decide: where a surface folds, in a crease or at a lip, blended normals point behind a
/// few triangles of good models (40 of the 5,040 of the bottle that script/art/glass.sh makes), and a closed surface
/// with one triangle turned around is no longer closed for light that is refracted. So triangles that are wound alike
/// are judged together: those on both sides of an edge that exactly two triangles share and run through in opposite
/// directions. Such a surface is wound against its normals when the cosines between each triangle's direction and the
/// normals of its corners have a negative sum.
///
/// `mesh` has normals of length 1 or 0 and no triangles without area. Takes linear time where every triangle agrees
/// with its own normals, and otherwise the time of sorting the edges.
std::vector<std::uint32_t> TrianglesAgainstNormals(const MeshData& mesh);

/// Whether the triangles bound a volume, their fronts outward: every edge is passed as often one way as the other.
/// Corners in the same place are one. Takes the time of sorting the edges.
bool IsClosed(const MeshData& mesh);

}  // namespace R3
