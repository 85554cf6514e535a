#pragma once

#include <span>

#include "source/parse/meshes/MeshFormat.h"

namespace ray {

/// Gives every corner of a triangle a normal: the mean of the normals of the triangles around its position that are
/// grouped with its own, each weighted by its angle there, so that the triangulation of faces does not matter.
/// Positions are equal if their coordinates are, whichever vertices the file has. Vertices whose corners get different
/// normals are split. A corner where more than 1024 triangles meet keeps the normal of its triangle.
///   source   weights: Thürmer, Wüthrich, Computing vertex normals from polygonal facets (1998)

/// Groups triangles whose normals differ by at most `degrees`, as the library GLM of Nate Robins does, which compares
/// them with the first one around each position. Replaces the mesh's normals.
void SmoothByAngle(R3::MeshData& mesh, double degrees);

/// Groups triangles with the same smoothing group; those of group 0 are flat. Keeps the mesh's own normals.
///   runs   the triangles' groups, as in MeshFile
void SmoothByGroups(R3::MeshData& mesh, std::span<const TriangleRun> runs);

}  // namespace ray
