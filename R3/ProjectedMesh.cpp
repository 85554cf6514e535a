#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "R3/Mesh.h"

namespace R3 {
namespace {

/// Returns the axis that a normal is nearest to, 0..2. Of equally near axes, y comes before z and z before x. Programs
/// print six digits, so that a slope of 45 degrees is off by a millionth, which must not decide.
int NearestAxis(const Vector& n) {
  constexpr double less = 1 - 1e-6;
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  if (y >= less * std::max(x, z)) return 1;
  return z >= less * x ? 2 : 0;
}

/// Returns a side of a box: twice the axis, plus 1 for the far side.
int SideOf(const Vector& normal) {
  const int axis = NearestAxis(normal);
  return 2 * axis + (std::array{normal.x, normal.y, normal.z}[static_cast<std::size_t>(axis)] > 0 ? 1 : 0);
}

R2::Point UvOnSide(int side, const Point& p) {
  const std::array<R2::Point, 6> uvs{{{p.z, p.y}, {-p.z, p.y}, {p.x, p.z}, {p.x, -p.z}, {-p.x, p.y}, {p.x, p.y}}};
  return uvs[static_cast<std::size_t>(side)];
}

Vector AreaOf(const MeshData& data, const std::array<std::uint32_t, 3>& t) {
  return Cross(data.positions[t[1]] - data.positions[t[0]], data.positions[t[2]] - data.positions[t[0]]);
}

/// Returns the side that each triangle faces; all triangles of a polygon face that of the whole.
std::vector<int> SidesOf(const MeshData& data) {
  Vector whole;
  for (const auto& t : data.triangles) whole = whole + AreaOf(data, t);
  std::vector<int> sides;
  for (const auto& t : data.triangles) sides.push_back(SideOf(data.is_one_polygon ? whole : AreaOf(data, t)));
  return sides;
}

/// Adds a copy of vertex `original`.
std::uint32_t Copied(MeshData& data, std::uint32_t original) {
  const auto copy = static_cast<std::uint32_t>(data.positions.size());
  data.positions.push_back(Point(data.positions[original]));
  if (!data.normals.empty()) data.normals.push_back(Normal(data.normals[original]));
  if (!data.colors.empty()) data.colors.push_back(std::array(data.colors[original]));
  return copy;
}

}  // namespace

std::unique_ptr<const Mesh> Mesh::Projected() const {
  assert(data_.uvs.empty());
  std::unique_ptr<Mesh> projected(new Mesh(*this));
  MeshData& data = projected->data_;
  const std::vector<int> sides = SidesOf(data);
  constexpr int none = -1;
  std::vector<int> first_sides(data.positions.size(), none);  // of each vertex; other sides use copies
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> copies;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::uint32_t& corner : data.triangles[i]) {
      int& first = first_sides[corner];
      if (first == none) first = sides[i];
      if (first == sides[i]) continue;
      const auto [copy, is_new] = copies.try_emplace({corner, sides[i]}, 0);
      if (is_new) copy->second = Copied(data, corner);
      corner = copy->second;
    }
  data.uvs.resize(data.positions.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (const std::uint32_t corner : data.triangles[i]) data.uvs[corner] = UvOnSide(sides[i], data.positions[corner]);
  return projected;
}

}  // namespace R3
