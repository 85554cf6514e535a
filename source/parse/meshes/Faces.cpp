#include "source/parse/meshes/Faces.h"

#include "source/parse/meshes/Polygon.h"

namespace ray {
namespace {

constexpr std::size_t max_triangles = std::size_t{1} << 28;  // 3 GB of indices, within what a mesh can count

}  // namespace

const char* Faces::Add(std::span<const std::uint32_t> places, std::span<const std::uint32_t> names,
                       const Token& where) {
  if (places.size() < 3) {
    too_small_.Add(where);
    return nullptr;
  }
  if (places.size() > max_triangles - mesh_.triangles.size()) return "the mesh has more than 2^28 triangles";
  if (places.size() == 3) {
    AddTriangle(names, {0, 1, 2}, where);
    return nullptr;
  }
  polygon_.clear();
  for (const std::uint32_t place : places) polygon_.push_back(mesh_.positions[place]);
  auto cuts = Triangulate(polygon_);
  if (!cuts) {
    ++fanned_;
    cuts = Fan(places.size());
  }
  for (const auto& cut : *cuts) AddTriangle(names, cut, where);
  return nullptr;
}

void Faces::AddTriangle(std::span<const std::uint32_t> names, const std::array<std::uint32_t, 3>& cut,
                        const Token& where) {
  mesh_.triangles.push_back({names[cut[0]], names[cut[1]], names[cut[2]]});
  mesh_.lines.push_back(LocationOf(0, where).line);
}

void Faces::Warn(const Text& file, Report& report) const {
  if (fanned_ > 0)
    report.Warn(Escaped(file.name),
                "concave faces with very many corners, triangulated as if convex: " + std::to_string(fanned_));
  too_small_.Warn(file, report, "face with fewer than 3 corners skipped", "faces with fewer than 3 corners skipped");
}

}  // namespace ray
