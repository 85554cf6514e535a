#include "R3/Winding.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "R3/FlatTriangle.h"

namespace R3 {
namespace {

/// Returns for each triangle the sum of the cosines between its direction and the normals of its corners, in [-3, 3].
std::vector<double> Agreements(const MeshData& mesh) {
  std::vector<double> agreements;
  agreements.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector sum = AsVector(mesh.normals[a]) + AsVector(mesh.normals[b]) + AsVector(mesh.normals[c]);
    agreements.push_back(Dot(FaceDirection(mesh.positions[a], mesh.positions[b], mesh.positions[c]), sum));
  }
  return agreements;
}

/// Maps each vertex to the first vertex at the same position, since files repeat positions once per normal.
std::vector<std::uint32_t> FirstAtPosition(const std::vector<Point>& positions) {
  const auto key = [&](std::uint32_t i) { return std::tie(positions[i].x, positions[i].y, positions[i].z); };
  std::vector<std::uint32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order,
                    [&](std::uint32_t i, std::uint32_t j) { return key(i) != key(j) ? key(i) < key(j) : i < j; });
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? first[order[k - 1]] : order[k];
  return first;
}

/// One side of a triangle.
struct Edge {
  std::uint32_t low, high, triangle;
  bool runs_down;  // from `high` to `low`

  bool IsAlong(const Edge& other) const { return low == other.low && high == other.high; }
};

std::vector<Edge> SortedEdges(const MeshData& mesh) {
  const std::vector<std::uint32_t> first = FirstAtPosition(mesh.positions);
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = first[mesh.triangles[t][k]], to = first[mesh.triangles[t][(k + 1) % 3]];
      edges.push_back({std::min(from, to), std::max(from, to), t, from > to});
    }
  std::ranges::sort(edges, {}, [](const Edge& e) { return std::tie(e.low, e.high, e.triangle); });
  return edges;
}

/// Disjoint sets of triangles, each identified by one of them. Source: Tarjan, Efficiency of a good but not linear set
/// union algorithm (1975), with path halving.
class Surfaces {
 public:
  explicit Surfaces(std::size_t triangles) : parent_(triangles) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t Of(std::uint32_t triangle) {
    while (parent_[triangle] != triangle) triangle = parent_[triangle] = parent_[parent_[triangle]];
    return triangle;
  }
  void Join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t of_a = Of(a), of_b = Of(b);
    parent_[std::max(of_a, of_b)] = std::min(of_a, of_b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

Surfaces SurfacesWoundAlike(const MeshData& mesh) {
  Surfaces surfaces(mesh.triangles.size());
  const std::vector<Edge> edges = SortedEdges(mesh);
  for (auto run = edges.begin(); run != edges.end();) {
    const auto end = std::find_if_not(run, edges.end(), [&](const Edge& e) { return e.IsAlong(*run); });
    if (end - run == 2 && run[0].runs_down != run[1].runs_down) surfaces.Join(run[0].triangle, run[1].triangle);
    run = end;
  }
  return surfaces;
}

/// Returns six times the volume that closed triangles bound, positive if their fronts are outward.
double SixVolumes(const MeshData& mesh) {
  double volume = 0;
  const Point& origin = mesh.positions[mesh.triangles[0][0]];
  for (const auto& [a, b, c] : mesh.triangles)
    volume += Dot(mesh.positions[a] - origin, Cross(mesh.positions[b] - origin, mesh.positions[c] - origin));
  return volume;
}

}  // namespace

bool IsClosed(const MeshData& mesh) {
  if (mesh.triangles.empty()) return false;
  const std::vector<Edge> edges = SortedEdges(mesh);
  for (auto run = edges.begin(); run != edges.end();) {
    const auto end = std::find_if_not(run, edges.end(), [&](const Edge& e) { return e.IsAlong(*run); });
    if (2 * std::count_if(run, end, [](const Edge& e) { return e.runs_down; }) != end - run) return false;
    run = end;
  }
  return SixVolumes(mesh) > 0;
}

std::vector<std::uint32_t> TrianglesAgainstNormals(const MeshData& mesh) {
  const std::vector<double> agreements = Agreements(mesh);
  if (std::ranges::none_of(agreements, [](double agreement) { return agreement < 0; })) return {};
  Surfaces surfaces = SurfacesWoundAlike(mesh);
  std::vector<double> of_surface(agreements.size());
  for (std::uint32_t t = 0; t < agreements.size(); ++t) of_surface[surfaces.Of(t)] += agreements[t];
  std::vector<std::uint32_t> against;
  for (std::uint32_t t = 0; t < agreements.size(); ++t)
    if (of_surface[surfaces.Of(t)] < 0) against.push_back(t);
  return against;
}

}  // namespace R3
