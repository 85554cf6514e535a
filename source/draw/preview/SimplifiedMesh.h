#pragma once

#include <cstdint>

#include "R3/MeshData.h"

namespace ray {

/// Returns a mesh of about `triangles` triangles that resembles this one from a distance. Vertices in one cell of a
/// grid over the mesh are merged at their mean, with the mean of their normals; triangles with two corners in one cell
/// are removed. A mesh without normals gets those of its triangles, so that the remaining ones are shaded like the
/// original. A mesh that has no more triangles than that is returned unchanged.
///   source   Rossignac and Borrel, Multi-resolution 3D approximations for rendering complex scenes (1993)
R3::MeshData SimplifiedMesh(const R3::MeshData& mesh, std::int64_t triangles);

}  // namespace ray
