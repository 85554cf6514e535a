#include "source/parse/scn/ScnText.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <utility>

#include "R3/Mesh.h"
#include "R3/Polygon.h"
#include "source/parse/CsgOf.h"
#include "source/parse/scn/QuotedName.h"
#include "source/scene/CameraText.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

/// Returns a vector that rounds to this one when it is normalized, as a mesh does with the normals it reads. A unit
/// vector itself may not, since its length is 1 only within rounding. Multiples of it round differently, and about
/// every third works; if none does, the last digits are lost.
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

/// The maximum number of triangles of flat polygons that are written corner by corner, as by a person rather than a
/// program. Longer ones would bury the scene.
constexpr int most_spelled_out = 64;

std::string TextOf(const char* word) { return word; }
std::string TextOf(const std::string& word) { return word; }
std::string TextOf(int number) { return std::to_string(number); }
std::string TextOf(double number) { return ToText(number); }
std::string TextOf(const R2::Color& c) { return ToText(c.r) + " " + ToText(c.g) + " " + ToText(c.b); }
std::string TextOf(const R3::Vector& v) { return ToText(v.x) + " " + ToText(v.y) + " " + ToText(v.z); }
std::string TextOf(const R2::Vector& v) { return ToText(v.x) + " " + ToText(v.y); }
std::string TextOf(const R3::Point& p) { return TextOf(FromOrigin(p)); }
std::string TextOf(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : " ") + ToText(number);
  return text;
}

/// Returns the command that makes exactly this mesh from its corners, triangle by triangle. Returns null if no command
/// does, or if the resulting mesh would be another lamp.
const char* PolygonCommandOf(const R3::Mesh& mesh, const Material& material) {
  const R3::MeshData& data = mesh.Data();
  const std::size_t corners = data.positions.size();
  const std::size_t most_corners = IsBlack(material.emission) ? most_spelled_out : R3::max_concave_corners;
  if (!data.is_one_polygon || !data.colors.empty() || corners < 3 || corners > most_corners) return nullptr;
  const auto cuts = R3::Triangulate(data.positions);
  if (!cuts) return nullptr;
  R3::MeshData again;
  again.positions = data.positions;
  again.triangles.assign(cuts->begin(), cuts->end());
  if (R3::Mesh(std::move(again)).Data().triangles != data.triangles) return nullptr;
  if (data.uvs.empty()) return "polygon";
  return corners == 4 && data.uvs == R3::QuadUvs() ? "quad" : nullptr;
}

class ScnWriter {
 public:
  ScnWriter(const Scene& scene, const std::filesystem::path& file)
      : scene_(scene), folder_(file.parent_path()), stem_(file.stem().string()) {}

  ScnText Write() && {
    SaySettings();
    text_ += CameraLine(scene_.camera) + "\n";
    SaySurroundings();
    SayLights();
    // Materials come first in the file, but only the nodes determine whether the default one needs an id.
    const std::string before = std::exchange(text_, {});
    SayNodes();
    const std::string nodes = std::exchange(text_, {});
    SayMaterials();
    written_.text = before + text_ + nodes;
    return std::move(written_);
  }

 private:
  static constexpr int default_material = 0;

  /// Writes a statement: a command and its arguments.
  template <class... Parts>
  void Say(const char* command, const Parts&... parts) {
    text_ += std::string(indentation_, ' ') + command;
    ((text_ += " " + TextOf(parts)), ...);
    text_ += "\n";
  }

  void SaySettings() {
    for (const SceneSetting& setting : scene_.settings) Say("set", setting.option, setting.value);
  }

  void SaySurroundings() {
    if (!IsBlack(scene_.background)) Say("background", scene_.background);
    if (!IsBlack(scene_.ambient)) Say("ambient", scene_.ambient);
    if (scene_.shadow_bias != 0) Say("shadow_bias", scene_.shadow_bias);
    if (!scene_.environment) return;
    if (const auto name = NameOf(scene_.environment->File(), "skipping the environment")) Say("environment", *name);
  }

  void SayLights() {
    if (scene_.has_default_lights) return;
    for (const auto& light : scene_.lights) {
      const R3::Recipe made = light->MadeFrom();
      Say(made.kind, made.arguments);
    }
    // A scene that names no light would get the default ones; this one emits nothing.
    if (scene_.lights.empty()) Say("dir_light", R2::Color{}, R3::Vector{0, -1, 0});
  }

  void SayMaterials() {
    for (std::size_t i = 1; i < scene_.materials.size(); ++i) SayMaterial(scene_.materials[i]);
    if (names_default_) SayMaterial(scene_.materials[default_material]);
  }

  void SayMaterial(const Material& m) {
    const int id = materials_said_++;
    const auto texture =
        m.texture ? NameOf(m.texture->file, "writing a material without its texture") : std::optional<std::string>();
    Say("material", m.ka, m.kd, m.ks, m.kt, m.emission, m.n, m.ir, texture.value_or("0"));
    if (m.kr != m.ks) Say("mirror", id, m.kr);
    if (!IsBlack(m.absorb)) Say("absorb", id, m.absorb);
    if (m.priority != 0) Say("priority", id, m.priority);
    if (m.coat != 0) Say("coat", id, m.coat);
    if (m.texture_multiplies_ka) Say("texture_ambient", id);
    if (m.texture_scale != R2::Vector{1, 1}) Say("texture_scale", id, m.texture_scale);
    if (m.projects_textures) Say("texture_project", id);
    if (m.one_sided) Say("one_sided", id);
    if (m.has_vertex_colors) Say("vertex_colors", id);
    if (m.color) Say("flat_color", id, *m.color);
    if (m.gloss > 0) Say("gloss", id, m.gloss, m.gloss_samples);
    if (m.specular_map)
      if (const auto map = NameOf(m.specular_map->file, "writing a material without its specular map"))
        Say("specular_map", id, *map);
    if (m.normal_map)
      if (const auto map = NameOf(m.normal_map->file, "writing a material without its normal map"))
        Say("normal_map", id, *map);
    if (!m.bump) return;
    if (const auto bump = NameOf(m.bump->file, "writing a material without its bump map"))
      Say("bump", id, *bump, m.bump_height);
  }

  /// A group that is being written.
  struct OpenGroup {
    const Node* group;
    std::size_t next;  // of its children
    int material;      // passed on to the children
  };

  void SayNodes() {
    std::vector<OpenGroup> open{{&scene_.root, 0, default_material}};  // not recursive: see Node
    for (;;) {
      OpenGroup& innermost = open.back();
      if (innermost.next == innermost.group->children.size()) {
        open.pop_back();
        if (open.empty()) return;
        Indent(open.size() - 1);
        Say("end");
        continue;
      }
      const Node& node = innermost.group->children[innermost.next++];
      const int material = node.material == Node::inherit ? innermost.material : node.material;
      if (!node.operation && (node.shape || node.line)) {
        SayPrimitive(node, scene_.materials[static_cast<std::size_t>(material)]);
      } else {
        SayBegin(node);
        open.push_back({&node, 0, material});
        Indent(open.size() - 1);
        if (node.motion != R3::Vector{}) Say("motion", node.motion);
      }
    }
  }

  /// Writes the indentation, limited so that nested groups do not produce more white space than text.
  void Indent(std::size_t depth) {
    constexpr std::size_t deepest = 16;
    indentation_ = 2 * std::min(depth, deepest);
  }

  void SayBegin(const Node& group) {
    if (group.operation)
      return Say("csg", std::string(csg_operations[static_cast<std::size_t>(*group.operation)]), IdOf(group));
    std::vector<double> entries;
    for (const auto& row : group.transform.m) entries.insert(entries.end(), row.begin(), row.end());
    entries.insert(entries.end(), {0, 0, 0, 1});
    Say("begin", IdOf(group), entries);
  }

  void SayPrimitive(const Node& node, const Material& material) {
    const int id = IdOf(node);
    if (node.line) return Say("line", id, node.line->start, node.line->end);
    if (const auto made = node.shape->MadeFrom()) {
      if (made->text.empty()) return Say(made->kind, id, made->arguments);
      return Say(made->kind, id, "\"" + made->text + "\"", made->arguments);
    }
    const auto* mesh = dynamic_cast<const R3::Mesh*>(node.shape.get());
    assert(mesh);  // other shapes are of a kind
    if (const char* const command = PolygonCommandOf(*mesh, material)) return SayPolygon(command, *mesh, id);
    if (IsSaidByTriangles(*mesh, material)) return SayTriangles(*mesh, id);
    if (mesh->Data().is_one_polygon && mesh->Elements() > 1 && !IsBlack(material.emission))
      written_.warnings.emplace_back(
          "an emissive polygon is written as a mesh: in mode whitted each of its triangles "
          "is a separate lamp");
    if (mesh->IsSmooth())
      Say("mesh", id, FileOf(*mesh), "smooth");
    else
      Say("mesh", id, FileOf(*mesh));
  }

  void SayPolygon(const std::string& command, const R3::Mesh& mesh, int id) {
    const std::vector<R3::Point>& corners = mesh.Data().positions;
    std::vector<double> numbers;
    if (command == "polygon") numbers.push_back(static_cast<double>(corners.size()));
    for (const R3::Point& p : corners) numbers.insert(numbers.end(), {p.x, p.y, p.z});
    Say(command.c_str(), id, numbers);
  }

  /// Returns true if one `tri` per triangle makes the same image, although they have their own texture coordinates and
  /// are separate lamps.
  bool IsSaidByTriangles(const R3::Mesh& mesh, const Material& material) const {
    const auto shows_more = [](const SceneSetting& setting) {
      return setting.option == "mode" &&
             (setting.value == "uv" || setting.value == "uv_color" || setting.value == "id");
    };
    return mesh.File().empty() && !mesh.IsSmooth() && mesh.Elements() <= most_spelled_out && !material.texture &&
           !material.specular_map && !material.bump && !material.normal_map && !material.has_vertex_colors &&
           IsBlack(material.emission) && std::none_of(scene_.settings.begin(), scene_.settings.end(), shows_more);
  }

  void SayTriangles(const R3::Mesh& mesh, int id) {
    for (int i = 0; i < mesh.Elements(); ++i) {
      const auto corners = mesh.Corners(i);
      Say("tri", id, corners[0], corners[1], corners[2]);
    }
  }

  /// Returns the name of the mesh's file, existing or to be written.
  std::string FileOf(const R3::Mesh& mesh) {
    const auto [place, is_new] = names_of_meshes_.try_emplace(&mesh);
    if (!is_new) return place->second;
    if (!mesh.File().empty())
      if (const auto name = NameOf(mesh.File(), "writing the mesh again, as a file next to the scene"))
        return place->second = *name;
    const std::string name = stem_ + "-" + std::to_string(written_.meshes.size() + 1) + ".obj";
    written_.meshes.push_back({name, ObjText(mesh)});
    return place->second = QuotedWhereNeeded(name);
  }

  /// Returns the material id; -1 to inherit.
  int IdOf(const Node& node) {
    if (node.material != default_material) return node.material == Node::inherit ? -1 : node.material - 1;
    names_default_ = true;
    return static_cast<int>(scene_.materials.size()) - 1;
  }

  /// Returns the name of a file in the text; std::nullopt, with a warning, for data that came from no file.
  std::optional<std::string> NameOf(const std::string& file, const std::string& otherwise) {
    if (file.empty()) {
      written_.warnings.push_back("an image came from no file: " + otherwise);
      return {};
    }
    const std::string name = std::filesystem::path(file).lexically_relative(folder_).string();
    if (name.starts_with("../")) written_.other_folders.insert(std::filesystem::path(file).parent_path().string());
    return QuotedWhereNeeded(name);
  }

  const Scene& scene_;
  std::filesystem::path folder_;
  std::string stem_;
  ScnText written_;
  std::string text_;
  std::size_t indentation_ = 0;
  int materials_said_ = 0;
  bool names_default_ = false;  // outside of a group where inheriting would give another
  std::map<const R3::Mesh*, std::string> names_of_meshes_;
};

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

ScnText WriteScn(const Scene& scene, const std::filesystem::path& file) { return ScnWriter(scene, file).Write(); }

}  // namespace ray
