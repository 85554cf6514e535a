#include "source/parse/meshes/Corners.h"

#include <algorithm>

namespace ray {
namespace {

/// Gives what is named by corners the names of vertices.
template <typename VertexOf>
void Rename(R3::MeshData& mesh, std::span<AddedVertex> added, const VertexOf& vertex_of) {
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& name : triangle) name = vertex_of(name);
  for (AddedVertex& vertex : added) vertex.from = vertex_of(vertex.from), vertex.to = vertex_of(vertex.to);
}

}  // namespace

void MakeVertices(R3::MeshData& mesh, std::span<const Corner> corners, std::span<AddedVertex> added,
                  std::span<const R2::Point> uvs, std::span<const R3::Normal> normals) {
  const auto is_plain = [](const Corner& c) { return c.uv == Corner::none && c.normal == Corner::none; };
  if (std::ranges::all_of(corners, is_plain))
    return Rename(mesh, added, [&](std::uint32_t corner) { return corners[corner].place; });
  std::vector<Corner> different(corners.begin(), corners.end());
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  Rename(mesh, added, [&](std::uint32_t corner) {
    const auto found = std::lower_bound(different.begin(), different.end(), corners[corner]);
    return static_cast<std::uint32_t>(found - different.begin());
  });

  std::vector<R3::Point> positions;
  std::vector<std::array<float, 3>> colors;
  for (const Corner& corner : different) {
    positions.push_back(mesh.positions[corner.place]);
    if (!mesh.colors.empty()) colors.push_back(mesh.colors[corner.place]);
    if (!uvs.empty()) mesh.uvs.push_back(corner.uv == Corner::none ? R2::Point{} : uvs[corner.uv]);
    if (!normals.empty()) mesh.normals.push_back(corner.normal == Corner::none ? R3::Normal{} : normals[corner.normal]);
  }
  mesh.positions = std::move(positions);
  mesh.colors = std::move(colors);
}

}  // namespace ray
