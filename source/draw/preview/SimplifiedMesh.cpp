#include "source/draw/preview/SimplifiedMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

#include "R3/Box.h"

namespace ray {
namespace {

/// Numbers the cells of a grid that contain vertices, in the order of the vertices.
class Clusters {
 public:
  Clusters(const std::vector<R3::Point>& positions, int across) {
    R3::Box box;
    for (const R3::Point& p : positions) box.Extend(p);
    const R3::Vector size = box.Size();
    const double longest = std::max({size.x, size.y, size.z, std::numeric_limits<double>::min()});
    const double per_length = across / longest;
    std::unordered_map<std::uint64_t, std::uint32_t> number_of_cell;
    of_vertex.reserve(positions.size());
    for (const R3::Point& p : positions) {
      const auto at = [&](double x) { return static_cast<std::uint64_t>(x * per_length); };
      const R3::Vector from = p - box.low;
      const std::uint64_t cell = at(from.x) << 42 | at(from.y) << 21 | at(from.z);
      of_vertex.push_back(
          number_of_cell.try_emplace(cell, static_cast<std::uint32_t>(number_of_cell.size())).first->second);
    }
    count = number_of_cell.size();
  }

  std::vector<std::uint32_t> of_vertex;
  std::size_t count = 0;
};

std::vector<R3::Point> MeanPositions(const R3::MeshData& mesh, const Clusters& clusters) {
  std::vector<R3::Vector> sums(clusters.count);
  std::vector<int> counts(clusters.count);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    R3::Vector& sum = sums[clusters.of_vertex[i]];
    sum = sum + (mesh.positions[i] - R3::Point{});
    ++counts[clusters.of_vertex[i]];
  }
  std::vector<R3::Point> means;
  for (std::size_t i = 0; i < sums.size(); ++i) means.push_back(R3::Point{} + sums[i] / counts[i]);
  return means;
}

/// Returns sums of the normals of the vertices, or of the triangles by their area if the vertices have none.
std::vector<R3::Normal> SumsOfNormals(const R3::MeshData& mesh, const Clusters& clusters) {
  std::vector<R3::Vector> sums(clusters.count);
  const auto add = [&](std::size_t vertex, const R3::Vector& normal) {
    R3::Vector& sum = sums[clusters.of_vertex[vertex]];
    sum = sum + normal;
  };
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) add(i, AsVector(mesh.normals[i]));
  if (mesh.normals.empty())
    for (const auto& corners : mesh.triangles) {
      const R3::Point& a = mesh.positions[corners[0]];
      const R3::Vector across = Cross(mesh.positions[corners[1]] - a, mesh.positions[corners[2]] - a);
      for (const std::uint32_t corner : corners) add(corner, across);
    }
  std::vector<R3::Normal> normals;
  for (const R3::Vector& sum : sums) {
    const double length = Length(sum);
    normals.push_back(AsNormal(length > 0 ? sum / length : R3::Vector{0, 1, 0}));
  }
  return normals;
}

/// Returns the value of each cluster's first vertex; empty if vertices have no values.
template <typename Value>
std::vector<Value> OfFirst(const std::vector<Value>& of_vertices, const Clusters& clusters) {
  std::vector<Value> first;
  for (std::size_t i = 0; i < of_vertices.size(); ++i)
    if (clusters.of_vertex[i] == first.size()) first.push_back(of_vertices[i]);
  return first;
}

}  // namespace

R3::MeshData SimplifiedMesh(const R3::MeshData& mesh, std::int64_t triangles) {
  constexpr double least_cells = 4, most_cells = 1e6;  // across; three numbers of cells fit into 64 bits
  if (static_cast<std::int64_t>(mesh.triangles.size()) <= triangles) return mesh;
  // A surface about as wide as the grid, counted on both sides, passes through about 3 cells per square, which has two
  // triangles each.
  const double cells = std::sqrt(static_cast<double>(triangles) / 6);
  const Clusters clusters(mesh.positions, static_cast<int>(std::clamp(cells, least_cells, most_cells)));
  R3::MeshData simple;
  simple.positions = MeanPositions(mesh, clusters);
  simple.normals = SumsOfNormals(mesh, clusters);
  simple.uvs = OfFirst(mesh.uvs, clusters);
  simple.colors = OfFirst(mesh.colors, clusters);
  for (const auto& corners : mesh.triangles) {
    const std::uint32_t a = clusters.of_vertex[corners[0]], b = clusters.of_vertex[corners[1]],
                        c = clusters.of_vertex[corners[2]];
    if (a != b && b != c && c != a) simple.triangles.push_back({a, b, c});
  }
  return simple;
}

}  // namespace ray
