#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "R3/MeshData.h"
#include "source/parse/meshes/Faces.h"

namespace ray {

/// A corner of a face in formats whose faces index places, texture coordinates and normals one by one.
struct Corner {
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::uint32_t place, uv = none, normal = none;

  friend auto operator<=>(const Corner&, const Corner&) = default;
};

/// Turns triangles of corners into triangles of vertices. A vertex of a mesh has one normal and one pair of texture
/// coordinates; where a file gives a place several of them, it becomes several vertices. Takes n log n time for n
/// corners.
///   mesh      positions, and colors of places, as the file has them; triangles that index `corners`
///   added     vertices between those of corners, which are renamed like them
///   uvs       what the corners' uv and normal index, likewise `normals`; where they are empty the mesh has none
void MakeVertices(R3::MeshData& mesh, std::span<const Corner> corners, std::span<AddedVertex> added,
                  std::span<const R2::Point> uvs, std::span<const R3::Normal> normals);

}  // namespace ray
