#include "R3/Mesh.h"

#include <algorithm>
#include <cassert>

#include "R3/HugePages.h"
#include "R3/Triangle.h"

namespace R3 {
namespace {

Vector AreaVector(const std::array<Point, 3>& c) { return Cross(c[1] - c[0], c[2] - c[0]); }

}  // namespace

Mesh::Mesh(MeshData data, bool smooth) : data_(std::move(data)), smooth_(smooth && !data_.normals.empty()) {
  assert(data_.normals.empty() || data_.normals.size() == data_.positions.size());
  assert(data_.uvs.empty() || data_.uvs.size() == data_.positions.size());
  const std::size_t before = data_.triangles.size();
  std::erase_if(data_.triangles, [&](const auto& t) {
    const std::array corners{data_.positions[t[0]], data_.positions[t[1]], data_.positions[t[2]]};
    return Unit(AreaVector(corners)) == Vector{};
  });
  dropped_ = static_cast<int>(before - data_.triangles.size());
  for (Normal& normal : data_.normals) normal = AsNormal(Unit(AsVector(normal)));
  PreferHugePages();
}

void Mesh::PreferHugePages() const {
  R3::PreferHugePages(data_.positions.data(), data_.positions.size() * sizeof(Point));
  R3::PreferHugePages(data_.triangles.data(), data_.triangles.size() * sizeof(data_.triangles[0]));
}

std::unique_ptr<const Mesh> Mesh::Moved(const Transform& move) const {
  std::unique_ptr<Mesh> moved(new Mesh);
  moved->data_ = data_;
  moved->smooth_ = smooth_;
  moved->dropped_ = dropped_;
  for (Point& p : moved->data_.positions) {
    p = move * p;
    if (!IsFinite(FromOrigin(p))) return nullptr;
  }
  // Not of unit length again: blends of them are then the same whether before or after the move.
  for (Normal& normal : moved->data_.normals) normal = AsNormal(TransposeTimes(move.Inverse(), AsVector(normal)));
  for (auto& triangle : moved->data_.triangles) {
    if (move.Mirrors()) std::swap(triangle[1], triangle[2]);
    const std::array corners{moved->data_.positions[triangle[0]], moved->data_.positions[triangle[1]],
                             moved->data_.positions[triangle[2]]};
    if (Unit(AreaVector(corners)) == Vector{}) return nullptr;
  }
  moved->PreferHugePages();
  return moved;
}

Box Mesh::Bounds(int element) const {
  Box box;
  for (const Point& corner : Corners(element)) box.Extend(corner);
  return box;
}

std::optional<Hit> Mesh::Intersect(const Ray& ray, int element) const {
  return IntersectTriangle(ShearedRay(ray), Corners(element));
}

Intersection Mesh::At(const Ray&, const Hit& hit, int element) const {
  const auto corners = Corners(element);
  const auto& indices = data_.triangles[static_cast<std::size_t>(element)];
  const std::array weights{1 - hit.u - hit.v, hit.u, hit.v};

  Intersection at;
  Vector position, magnitude;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector share = weights[i] * FromOrigin(corners[i]);
    position = position + share;
    magnitude = magnitude + Abs(share);
  }
  at.position = Point{} + position;
  // Physically Based Rendering (2023), section 6.8.5: gamma(7) for the sum. The next test of the same triangle sums its
  // corners' distances, so its t errs by a share of the largest of them whichever way the triangle lies: a triangle in
  // the plane z = 0 must not be left from z = 0 exactly.
  double farthest = 0;
  for (const Point& corner : corners) farthest = std::max(farthest, MaxComponent(Abs(corner - at.position)));
  at.error = Gamma(7) * magnitude + Gamma(16) * Vector{farthest, farthest, farthest};
  at.normal = at.shading_normal = AsNormal(Unit(AreaVector(corners)));

  if (smooth_) {
    Vector sum;
    for (std::size_t i = 0; i < 3; ++i) sum = sum + weights[i] * AsVector(data_.normals[indices[i]]);
    const Vector blended = Unit(sum);
    // A blend of opposite or missing normals says nothing: the face's stays.
    if (blended != Vector{}) at.shading_normal = AsNormal(blended);
  }
  if (!data_.uvs.empty())
    for (std::size_t i = 0; i < 3; ++i) {
      at.uv.x += weights[i] * data_.uvs[indices[i]].x;
      at.uv.y += weights[i] * data_.uvs[indices[i]].y;
    }
  return at;
}

}  // namespace R3
