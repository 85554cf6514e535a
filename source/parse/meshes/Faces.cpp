#include "source/parse/meshes/Faces.h"

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
  if (const auto loops = Uncrossed(polygon_)) {
    AddLoops(*loops, names, where);
    return nullptr;
  }
  auto cuts = Triangulate(polygon_);
  if (!cuts) {
    ++fanned_;
    cuts = Fan(places.size());
  }
  for (const auto& cut : *cuts) AddTriangle(names, cut, where);
  return nullptr;
}

void Faces::AddLoops(const Loops& cut, std::span<const std::uint32_t> names, const Token& where) {
  const std::size_t first_added = added_.size();
  const auto corners = static_cast<std::uint32_t>(polygon_.size());
  for (const auto& [side, share] : cut.crossings) {
    const std::uint32_t next = (side + 1) % corners;
    polygon_.push_back(polygon_[side] + share * (polygon_[next] - polygon_[side]));
    added_.push_back({names[side], names[next], share});
  }
  for (const std::vector<std::uint32_t>& loop : cut.loops) {
    std::vector<R3::Point> places;
    for (const std::uint32_t i : loop) places.push_back(polygon_[i]);
    for (const auto& triangle : Triangulate(places).value_or(Fan(places.size()))) {
      std::array<std::uint32_t, 3> of_names{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t i = loop[triangle[k]];
        if (i < corners)
          of_names[k] = names[i];
        else
          uses_.push_back({mesh_.triangles.size(), k, first_added + (i - corners)});
      }
      AddTriangle(of_names, {0, 1, 2}, where);
    }
  }
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
