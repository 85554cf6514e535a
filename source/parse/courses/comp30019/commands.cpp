#include <algorithm>
#include <array>

#include "source/parse/courses/comp30019/Reader.h"
#include "source/text/Suggestion.h"

namespace ray::comp30019 {
namespace {

/// A kind of material: the use of its color and its index of refraction.
struct MaterialKind {
  std::string_view name;
  bool needs_index;  // above 0
  void (*fill)(Material&, const R2::Color& color, double index);
};

// Varnish, and most plastics. The course's files give their glossy surfaces an index of 1, which would reflect nothing.
constexpr double usual_coat = 1.5;

// In the order of the course's enumeration, whose numbers are accepted in place of the names.
constexpr std::array kinds{
    MaterialKind{"Diffuse", false, [](Material& m, const R2::Color& color, double) { m.kd = color; }},
    MaterialKind{"Reflective", false,
                 [](Material& m, const R2::Color&, double) {
                   m.kr = R2::Color{1, 1, 1};
                 }},
    MaterialKind{"Refractive", true,
                 [](Material& m, const R2::Color& color, double index) {
                   m.kt = R2::Color{1, 1, 1};
                   m.ir = index;
                   m.absorb = color;
                 }},
    MaterialKind{"Emissive", false, [](Material& m, const R2::Color& color, double) { m.emission = color; }},
    MaterialKind{"Glossy", true,
                 [](Material& m, const R2::Color& color, double index) {
                   m.kd = color;
                   m.coat = index == 1 ? usual_coat : index;
                 }},
};

const MaterialKind* ReadKind(Line& line) {
  const Token word = line.Word("kind");
  std::array<std::string_view, kinds.size()> names;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (word.text == kinds[i].name || word.text == std::to_string(i)) return &kinds[i];
    names[i] = kinds[i].name;
  }
  line.Error(word, "unknown kind of material " + Quoted(word.text), Suggestion(word.text, names, "kinds"));
  return nullptr;
}

/// Warns about an emissive plane, which is infinite and cannot be sampled.
void WarnOfEmission(Reader& reader, const Line& plane, int material) {
  if (!IsBlack(reader.MaterialAt(material).emission))
    reader.Warn(plane.Command(), "an emissive Plane is seen but gives no light");
}

void ReadMaterial(Reader& reader, Line& line) {
  Material& material = reader.NewMaterial(line);
  const MaterialKind* kind = ReadKind(line);
  const Triple color = reader.ReadColor(line, "color");
  const Number index = line.Real("index of refraction");
  if (!line.IsGood()) return;
  if (kind->needs_index && !(index.value > 0))
    return line.Error(index.token, "index of refraction must be positive, got " + Escaped(index.token.text));
  material.ka = material.kd = material.ks = material.kr = {};
  material.color = ColorOf(color);
  kind->fill(material, ColorOf(color), index.value);
}

void ReadPointLight(Reader& reader, Line& line) {
  reader.Declare(Reader::Space::light, line);
  const R3::Point p = Mirrored(reader.ReadPoint(line, "position"));
  const R2::Color c = ColorOf(reader.ReadColor(line, "color"));
  if (line.IsGood()) reader.AddLight("point_light", {c.r, c.g, c.b, p.x, p.y, p.z, 1, 0, 0});
}

void ReadPlane(Reader& reader, Line& line) {
  reader.Declare(Reader::Space::entity, line);
  const R3::Point p = Mirrored(reader.ReadPoint(line, "point"));
  const Triple normal = reader.ReadPoint(line, "normal");
  const R3::Point n = Mirrored(normal);
  const int material = reader.ReadMaterial(line);
  if (!line.IsGood()) return;
  if (n == R3::Point{}) return line.Error(normal[0].token, "normal must not be 0 0 0");
  WarnOfEmission(reader, line, material);
  reader.AddShape(line, "plane", {p.x, p.y, p.z, n.x, n.y, n.z}, material);
}

void ReadSphere(Reader& reader, Line& line) {
  reader.Declare(Reader::Space::entity, line);
  const R3::Point c = Mirrored(reader.ReadPoint(line, "center"));
  const Number radius = reader.ReadCoordinate(line, "radius");
  const int material = reader.ReadMaterial(line);
  if (!line.IsGood()) return;
  if (!(radius.value > 0))
    return line.Error(radius.token, "radius must be positive, got " + Escaped(radius.token.text));
  reader.AddShape(line, "sphere", {c.x, c.y, c.z, radius.value}, material);
}

// The mirror image of clockwise corners is counter-clockwise if two of them are swapped.
void ReadTriangle(Reader& reader, Line& line) {
  reader.Declare(Reader::Space::entity, line);
  const R3::Point a = Mirrored(reader.ReadPoint(line, "first corner"));
  const R3::Point b = Mirrored(reader.ReadPoint(line, "second corner"));
  const R3::Point c = Mirrored(reader.ReadPoint(line, "third corner"));
  const int material = reader.ReadMaterial(line);
  if (line.IsGood()) reader.AddShape(line, "tri", {a.x, a.y, a.z, c.x, c.y, c.z, b.x, b.y, b.z}, material);
}

void ReadObjModel(Reader& reader, Line& line) {
  reader.Declare(Reader::Space::entity, line);
  const Token file = line.Name("file");
  const R3::Point offset = Mirrored(reader.ReadPoint(line, "offset"));
  const Number scale = reader.ReadCoordinate(line, "scale");
  const int material = reader.ReadMaterial(line);
  if (line.IsGood() && scale.value == 0) line.Error(scale.token, "scale must not be 0");
  reader.AddModel(line, file, offset, scale.value, material);
}

constexpr std::array commands{
    Command{"Material", "Material \"name\" kind (r, g, b) index", ReadMaterial},
    Command{"PointLight", "PointLight \"name\" (x, y, z) (r, g, b)", ReadPointLight},
    Command{"Plane", "Plane \"name\" (x, y, z) (x, y, z) \"material\"", ReadPlane},
    Command{"Sphere", "Sphere \"name\" (x, y, z) radius \"material\"", ReadSphere},
    Command{"Triangle", "Triangle \"name\" (x, y, z) (x, y, z) (x, y, z) \"material\"", ReadTriangle},
    Command{"ObjModel", "ObjModel \"name\" \"file\" (x, y, z) scale \"material\"", ReadObjModel},
};

constexpr auto command_names = [] {
  std::array<std::string_view, commands.size()> all;
  std::ranges::transform(commands, all.begin(), &Command::name);
  return all;
}();

}  // namespace

const Command* FindCommand(std::string_view name) {
  const auto found = std::ranges::find(commands, name, &Command::name);
  return found == commands.end() ? nullptr : &*found;
}

std::span<const std::string_view> CommandNames() { return command_names; }

}  // namespace ray::comp30019
