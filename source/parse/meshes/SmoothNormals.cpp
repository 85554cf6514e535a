#include "source/parse/meshes/SmoothNormals.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>
#include <utility>

#include "R1/Elementary.h"
#include "R3/Vector.h"
#include "source/parse/meshes/Faces.h"

namespace ray {
namespace {

constexpr std::size_t most_around = 1024;  // the number of pairs is quadratic

/// A corner of a triangle and its contribution to a mean normal.
struct Wedge {
  std::uint32_t triangle;
  R3::Vector normal;  // of the triangle, unit or zero
  double angle;
};

/// The corners of triangles, sorted by position.
class Smoothing {
 public:
  explicit Smoothing(R3::MeshData& mesh) : mesh_(mesh), corners_(3 * mesh.triangles.size()) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = mesh.triangles[t][k];
        const bool has_uv = !mesh.uvs.empty();
        corners_[3 * t + k] = {vertex, has_uv ? vertex : Corner::none};
      }
  }

  /// Calls `belong(a, b)` for pairs of triangles around each position. Corners without `is_free(corner)` keep their
  /// normal.
  template <class Belong, class IsFree>
  void Run(const Belong& belong, const IsFree& is_free) {
    std::vector<std::uint32_t> order(corners_.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto place = [&](std::uint32_t corner) -> const R3::Point& {
      return mesh_.positions[corners_[corner].place];
    };
    const auto key = [&](std::uint32_t corner) {
      const R3::Point& p = place(corner);
      return std::array{p.x, p.y, p.z};
    };
    std::ranges::sort(order,
                      [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
      while (last < order.size() && place(order[last]) == place(order[first])) ++last;
      SmoothPlace(std::span(order).subspan(first, last - first), belong, is_free);
    }
    RenameTriangles();
  }

 private:
  template <class Belong, class IsFree>
  void SmoothPlace(std::span<const std::uint32_t> corners, const Belong& belong, const IsFree& is_free) {
    wedges_.clear();
    for (const std::uint32_t corner : corners) wedges_.push_back(WedgeAt(corner));
    const bool is_crowded = corners.size() > most_around;
    const std::size_t first = normals_.size();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Corner& corner = corners_[corners[i]];
      if (!is_free(corner))
        corner.normal = NumberOf(mesh_.normals[corner.place], is_crowded ? normals_.size() : first);
      else if (is_crowded)
        corner.normal = NumberOf(AsNormal(wedges_[i].normal), normals_.size());
      else
        corner.normal = NumberOf(MeanAround(wedges_[i], belong), first);
    }
  }

  template <class Belong>
  R3::Normal MeanAround(const Wedge& wedge, const Belong& belong) const {
    R3::Vector sum;
    for (const Wedge& other : wedges_)
      if (belong(wedge, other)) sum = sum + other.angle * other.normal;
    return AsNormal(Unit(sum));
  }

  Wedge WedgeAt(std::uint32_t corner) const {
    const std::uint32_t t = corner / 3, k = corner % 3;
    const auto& triangle = mesh_.triangles[t];
    const auto at = [&](std::uint32_t i) { return mesh_.positions[triangle[(k + i) % 3]]; };
    const R3::Vector a = Unit(at(1) - at(0)), b = Unit(at(2) - at(0)), across = Cross(a, b);
    return {t, Unit(across), R1::Atan2(Length(across), Dot(a, b))};
  }

  /// Returns the number of a normal. Corners at one position mostly have few normals, distinguished by their bits.
  std::uint32_t NumberOf(const R3::Normal& normal, std::size_t first) {
    const auto known = std::find(normals_.begin() + static_cast<std::ptrdiff_t>(first), normals_.end(), normal);
    const auto number = static_cast<std::uint32_t>(known - normals_.begin());
    if (known == normals_.end()) normals_.push_back(normal);
    return number;
  }

  void RenameTriangles() {
    std::uint32_t corner = 0;
    for (auto& triangle : mesh_.triangles)
      for (std::uint32_t& name : triangle) name = corner++;
    mesh_.normals.clear();
    MakeVertices(mesh_, corners_, {}, std::exchange(mesh_.uvs, {}), normals_);
  }

  R3::MeshData& mesh_;
  std::vector<Corner> corners_;
  std::vector<R3::Normal> normals_;
  std::vector<Wedge> wedges_;
};

}  // namespace

void SmoothByAngle(R3::MeshData& mesh, double degrees) {
  const double least_cosine = R1::Cos(degrees * std::numbers::pi / 180);
  Smoothing(mesh).Run([&](const Wedge& a, const Wedge& b) { return Dot(a.normal, b.normal) >= least_cosine; },
                      [](const Corner&) { return true; });
}

void SmoothByGroups(R3::MeshData& mesh, std::span<const TriangleRun> runs) {
  const std::vector<std::uint32_t> groups = ValuesOfTriangles(runs, mesh.triangles.size(), 0);
  const auto belong = [&](const Wedge& a, const Wedge& b) {
    return a.triangle == b.triangle || (groups[a.triangle] != 0 && groups[a.triangle] == groups[b.triangle]);
  };
  const auto has_no_normal = [&](const Corner& corner) {
    return mesh.normals.empty() || mesh.normals[corner.place] == R3::Normal{};
  };
  Smoothing(mesh).Run(belong, has_no_normal);
}

}  // namespace ray
