#include "source/parse/scn/ObjText.h"

#include "source/text/NumberText.h"

namespace ray {
namespace {

/// A vector that rounds to this one when it is made a unit vector, as a mesh does with the normals it reads. A unit
/// vector itself may not: its length is 1 only within rounding. Multiples of it are rounded in other ways, and about
/// every third does; the last digits of one that has none are lost.
R3::Vector BeforeUnit(const R3::Vector& unit) {
  constexpr int most_tries = 1000;
  for (int scale = 1; scale <= most_tries; ++scale)
    if (const R3::Vector v = scale * unit; Unit(v) == unit) return v;
  return unit;
}

template <class Number>
std::string Numbers(Number a, Number b, Number c) {
  return " " + ToText(a) + " " + ToText(b) + " " + ToText(c);
}

std::string Corner(std::uint32_t index, bool has_uv, bool has_normal) {
  const std::string number = std::to_string(index + 1);
  if (!has_uv && !has_normal) return number;
  return number + "/" + (has_uv ? number : "") + (has_normal ? "/" + number : "");
}

}  // namespace

std::string ObjText(const R3::Mesh& mesh) {
  const R3::MeshData& data = mesh.Data();
  const bool has_uv = !data.uvs.empty(), has_normal = mesh.IsSmooth();
  std::string text;
  for (std::size_t i = 0; i < data.positions.size(); ++i) {
    const R3::Point& p = data.positions[i];
    text += "v" + Numbers(p.x, p.y, p.z);
    if (!data.colors.empty()) text += Numbers(data.colors[i][0], data.colors[i][1], data.colors[i][2]);
    text += "\n";
  }
  for (const R2::Point& uv : data.uvs) text += "vt " + ToText(uv.x) + " " + ToText(uv.y) + "\n";
  if (has_normal)
    for (const R3::Normal& normal : data.normals) {
      const R3::Vector n = BeforeUnit(AsVector(normal));
      text += "vn" + Numbers(n.x, n.y, n.z) + "\n";
    }
  for (const auto& triangle : data.triangles) {
    text += "f";
    for (const std::uint32_t index : triangle) text += " " + Corner(index, has_uv, has_normal);
    text += "\n";
  }
  return text;
}

}  // namespace ray
