#pragma once

#include <cstdint>

#include "R3/MeshData.h"

namespace ray {

/// A mesh of about `triangles` triangles that looks like this one from afar: vertices in one cell of a grid over the
/// mesh become one, at their mean, with the mean of their normals; triangles with two corners in one cell go. A mesh
/// without normals gets those of its triangles, so that the few left are shaded as the many were. A mesh that has no
/// more triangles than that is returned unchanged.
///   source   Rossignac and Borrel, Multi-resolution 3D approximations for rendering complex scenes (1993)
R3::MeshData SimplifiedMesh(const R3::MeshData& mesh, std::int64_t triangles);

}  // namespace ray
