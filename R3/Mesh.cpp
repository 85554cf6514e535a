#include "R3/Mesh.h"

#include <algorithm>
#include <cassert>

#include "R3/FlatTriangle.h"
#include "R3/Triangle.h"
#include "R3/Winding.h"

namespace R3 {
namespace {

/// Returns the point of a flat triangle that is the mean of its corners by weights whose sum is 1.
R3_USES_FMA
Intersection AtWeights(const std::array<const Point*, 3>& corners, const std::array<double, 3>& weights) {
  Intersection at;
  const auto& [p, q, r] = corners;
  const SurfacePlace place = PlaceOnTriangle(*p, *q, *r, {weights[0], weights[1], weights[2]});
  at.position = place.position, at.error = place.error;
  at.normal = at.shading_normal = AsNormal(FaceDirection(*p, *q, *r));
  return at;
}

}  // namespace

std::vector<R2::Point> TriUvs() { return {{0, 0}, {1, 0}, {0, 1}}; }

Mesh::Mesh(MeshData data, bool smooth, std::string file)
    : data_(std::move(data)), smooth_(smooth && !data_.normals.empty()), file_(std::move(file)) {
  assert(data_.normals.empty() || data_.normals.size() == data_.positions.size());
  assert(data_.uvs.empty() || data_.uvs.size() == data_.positions.size());
  assert(data_.colors.empty() || data_.colors.size() == data_.positions.size());
  assert(data_.lines.empty() || data_.lines.size() == data_.triangles.size());
  DropTrianglesWithoutArea();
  for (Normal& normal : data_.normals) normal = AsNormal(Unit(AsVector(normal)));
  if (smooth_) TurnToNormals();
  data_.lines = {};
}

void Mesh::DropTrianglesWithoutArea() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < data_.triangles.size(); ++i) {
    const auto& t = data_.triangles[i];
    if (FaceDirection(data_.positions[t[0]], data_.positions[t[1]], data_.positions[t[2]]) == Vector{}) continue;
    data_.triangles[kept] = t;
    if (!data_.lines.empty()) data_.lines[kept] = data_.lines[i];
    ++kept;
  }
  dropped_ = static_cast<int>(data_.triangles.size() - kept);
  data_.triangles.resize(kept);
}

void Mesh::TurnToNormals() {
  const std::vector<std::uint32_t> against = TrianglesAgainstNormals(data_);
  for (const std::uint32_t t : against) std::swap(data_.triangles[t][1], data_.triangles[t][2]);
  turned_ = static_cast<int>(against.size());
  if (turned_ > 0 && !data_.lines.empty()) first_turned_line_ = data_.lines[against[0]];
}

std::optional<Recipe> Mesh::MadeFrom() const {
  const std::array<std::uint32_t, 3> whole{0, 1, 2};
  const bool is_whole = data_.triangles.empty() ? dropped_ == 1 : Elements() == 1 && data_.triangles[0] == whole;
  if (smooth_ || !is_whole || data_.positions.size() != 3 || data_.uvs != TriUvs()) return {};
  Recipe tri{"tri", {}};
  for (const Point& p : data_.positions) tri.arguments.insert(tri.arguments.end(), {p.x, p.y, p.z});
  return tri;
}

std::unique_ptr<const Mesh> Mesh::Moved(const Transform& move) const {
  std::unique_ptr<Mesh> moved(new Mesh);
  moved->data_ = data_;
  moved->smooth_ = smooth_;
  moved->dropped_ = dropped_;
  moved->turned_ = turned_;
  moved->first_turned_line_ = first_turned_line_;
  for (Point& p : moved->data_.positions) {
    p = move * p;
    if (!IsFinite(FromOrigin(p))) return nullptr;
  }
  // Not normalized, so that blends are equal before and after the move.
  for (Normal& normal : moved->data_.normals) normal = AsNormal(TransposeTimes(move.Inverse(), AsVector(normal)));
  for (auto& triangle : moved->data_.triangles) {
    if (move.Mirrors()) std::swap(triangle[1], triangle[2]);
    const auto corner = [&](std::size_t i) { return moved->data_.positions[triangle[i]]; };
    if (FaceDirection(corner(0), corner(1), corner(2)) == Vector{}) return nullptr;
  }
  return moved;
}

Box Mesh::Bounds(int element) const {
  Box box;
  for (const Point* corner : CornersInPlace(element)) box.Extend(*corner);
  return box;
}

std::optional<Hit> Mesh::Intersect(const Ray& ray, int element) const {
  return IntersectTriangle(ShearedRay(ray), Corners(element));
}

Intersection Mesh::At(const Ray&, const Hit& hit, int element) const {
  const std::array weights{1 - hit.u - hit.v, hit.u, hit.v};
  Intersection at = AtWeights(CornersInPlace(element), weights);
  if (!smooth_ && data_.uvs.empty()) return at;

  const auto& indices = data_.triangles[static_cast<std::size_t>(element)];
  if (smooth_) {
    Vector sum;
    for (std::size_t i = 0; i < 3; ++i) sum = sum + weights[i] * AsVector(data_.normals[indices[i]]);
    const Vector blended = Unit(sum);
    // A blend of opposite or missing normals is undefined; the face's normal stays.
    if (blended != Vector{}) at.shading_normal = AsNormal(blended);
  }
  if (!data_.uvs.empty())
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      at.uv.x += weights[i] * data_.uvs[indices[i]].x;
      at.uv.y += weights[i] * data_.uvs[indices[i]].y;
    }
  return at;
}

UvTangents Mesh::UvTangentsAt(const Ray&, const Hit&, int element) const {
  if (data_.uvs.empty()) return {};
  const auto [p, q, r] = CornersInPlace(element);
  const auto& indices = data_.triangles[static_cast<std::size_t>(element)];
  const auto uv = [&](std::size_t corner) { return data_.uvs[indices[corner]]; };
  return {*q - *p, *r - *p, uv(1) - uv(0), uv(2) - uv(0)};
}

R2::Color Mesh::ColorAt(const Hit& hit, int element) const {
  if (data_.colors.empty()) return {1, 1, 1};
  const std::array weights{1 - hit.u - hit.v, hit.u, hit.v};
  R2::Color blend;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& c = data_.colors[data_.triangles[static_cast<std::size_t>(element)][i]];
    blend += weights[i] * R2::Color{c[0], c[1], c[2]};
  }
  return blend;
}

bool Mesh::IsClosed() const { return R3::IsClosed(data_); }

void Mesh::AppendBlend(const std::array<std::uint32_t, 3>& corners, const std::array<double, 3>& weights,
                       MeshData& mesh) const {
  Vector position, normal;
  R2::Point uv;
  std::array<float, 3> color{};
  for (std::size_t k = 0; k < 3; ++k) {
    position = position + weights[k] * FromOrigin(data_.positions[corners[k]]);
    if (smooth_) normal = normal + weights[k] * AsVector(data_.normals[corners[k]]);
    if (!data_.uvs.empty()) uv.x += weights[k] * data_.uvs[corners[k]].x;
    if (!data_.uvs.empty()) uv.y += weights[k] * data_.uvs[corners[k]].y;
    if (!data_.colors.empty())
      for (std::size_t c = 0; c < 3; ++c) color[c] += static_cast<float>(weights[k]) * data_.colors[corners[k]][c];
  }
  mesh.positions.push_back(Point{} + position);
  if (smooth_) mesh.normals.push_back(AsNormal(Unit(normal)));
  if (!data_.uvs.empty()) mesh.uvs.push_back(uv);
  if (!data_.colors.empty()) mesh.colors.push_back(color);
}

MeshData Mesh::Tessellate(int fineness) const {
  const double shares = fineness / (4 * std::sqrt(std::max(1.0, static_cast<double>(Elements()))));
  const auto pieces = static_cast<std::uint32_t>(std::max(1.0, shares));  // per side of a triangle
  MeshData cut;
  if (pieces == 1) {
    cut = data_;
    if (!smooth_) cut.normals.clear();
    return cut;
  }
  for (const auto& triangle : data_.triangles) {
    // Row r, counted from corner 0 towards the opposite side, has r + 1 points.
    const auto first = static_cast<std::uint32_t>(cut.positions.size());
    const auto at = [&](std::uint32_t row, std::uint32_t i) { return first + row * (row + 1) / 2 + i; };
    for (std::uint32_t row = 0; row <= pieces; ++row)
      for (std::uint32_t i = 0; i <= row; ++i)
        AppendBlend(triangle,
                    {static_cast<double>(pieces - row) / pieces, static_cast<double>(row - i) / pieces,
                     static_cast<double>(i) / pieces},
                    cut);
    for (std::uint32_t row = 0; row < pieces; ++row)
      for (std::uint32_t i = 0; i <= row; ++i) {
        cut.triangles.push_back({at(row, i), at(row + 1, i), at(row + 1, i + 1)});
        if (i < row) cut.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row, i + 1)});
      }
  }
  return cut;
}

}  // namespace R3
