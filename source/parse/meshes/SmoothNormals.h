#pragma once

#include <span>

#include "source/parse/meshes/MeshFormat.h"

namespace ray {

/// Gives every corner of a triangle a normal: the mean of the normals of those triangles around its place that belong
/// together with its own, each weighted by its angle there, so that it does not matter how faces were triangulated.
/// Places are the same where their coordinates are, whatever vertices the file makes of them. Vertices whose corners
/// get different normals are split. A corner where more than 1024 triangles meet keeps the normal of its triangle.
///   source   weights: Thürmer, Wüthrich, Computing vertex normals from polygonal facets (1998)

/// Together belong triangles whose normals differ by at most so many degrees, as in the library GLM of Nate Robins,
/// which compares them with the first one around each place. Normals that the mesh has are replaced.
void SmoothByAngle(R3::MeshData& mesh, double degrees);

/// Together belong triangles of one smoothing group; those of group 0 are flat. Normals that the mesh has are kept.
///   runs   the triangles' groups, as MeshFile has them
void SmoothByGroups(R3::MeshData& mesh, std::span<const TriangleRun> runs);

}  // namespace ray
