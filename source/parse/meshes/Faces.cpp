#include "source/parse/meshes/Faces.h"

#include <algorithm>

#include "R3/Polygon.h"

namespace ray {
namespace {

constexpr std::size_t max_triangles = std::size_t{1} << 28;  // 3 GB of indices, within what a mesh can count

/// Replaces the names of corners by the names of vertices.
template <typename VertexOf>
void Rename(R3::MeshData& mesh, std::span<AddedVertex> added, const VertexOf& vertex_of) {
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& name : triangle) name = vertex_of(name);
  for (AddedVertex& vertex : added) vertex.from = vertex_of(vertex.from), vertex.to = vertex_of(vertex.to);
}

}  // namespace

const char* Faces::Add(std::span<const std::uint32_t> places, std::span<const std::uint32_t> names,
                       const Token& where) {
  if (places.size() < 3) {
    too_small_.Add(where);
    return nullptr;
  }
  if (places.size() > max_triangles - mesh_.triangles.size()) return "the mesh has more than 2^28 triangles";
  if (places.size() == 3) {
    AddTriangle({names[0], names[1], names[2]}, where);
    return nullptr;
  }
  polygon_.clear();
  for (const std::uint32_t place : places) polygon_.push_back(mesh_.positions[place]);
  auto cut = R3::CutApart(polygon_);
  if (!cut) {
    ++fanned_;
    cut = R3::CutPolygon{R3::Fan(places.size())};
  }
  const std::size_t first_added = added_.size();
  for (const auto& [side, share] : cut->crossings)
    added_.push_back({names[side], names[(side + 1) % places.size()], share});
  for (const auto& triangle : cut->cuts) {
    std::array<std::uint32_t, 3> of_names{};
    for (std::size_t k = 0; k < 3; ++k)
      if (triangle[k] < places.size())
        of_names[k] = names[triangle[k]];
      else
        uses_.push_back({mesh_.triangles.size(), k, first_added + (triangle[k] - places.size())});
    AddTriangle(of_names, where);
  }
  return nullptr;
}

void Faces::AddVertices() {
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (const auto& [from, to, share] : added_) {
    const auto between = [s = share, a = from, b = to](auto& list) {
      if (!list.empty()) list.push_back(list[a] + s * (list[b] - list[a]));
    };
    between(mesh_.positions);
    between(mesh_.uvs);
    const double rest = 1 - share;
    if (!mesh_.normals.empty()) {
      const R3::Normal &n = mesh_.normals[from], &m = mesh_.normals[to];
      mesh_.normals.push_back({rest * n.x + share * m.x, rest * n.y + share * m.y, rest * n.z + share * m.z});
    }
    if (!mesh_.colors.empty()) {
      const auto c = mesh_.colors[from], d = mesh_.colors[to];
      std::array<float, 3> color{};
      for (std::size_t k = 0; k < 3; ++k) color[k] = static_cast<float>(rest * c[k] + share * d[k]);
      mesh_.colors.push_back(color);
    }
  }
  for (const Use& use : uses_)
    mesh_.triangles[use.triangle][use.corner] = first + static_cast<std::uint32_t>(use.added);
}

void Faces::AddTriangle(const std::array<std::uint32_t, 3>& names, const Token& where) {
  mesh_.triangles.push_back(names);
  if (where.line != 0) mesh_.lines.push_back(LocationOf(0, where).line);
}

void Faces::Warn(const Text& file, Report& report) const {
  if (fanned_ > 0)
    report.Warn(Escaped(file.name),
                "concave faces with very many corners, triangulated as if convex: " + std::to_string(fanned_));
  too_small_.Warn(file, report, "face with fewer than 3 corners skipped", "faces with fewer than 3 corners skipped");
}

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
