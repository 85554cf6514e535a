#include <array>

#include "source/parse/courses/comp30019/Reader.h"
#include "source/text/Suggestion.h"

namespace ray::comp30019 {
namespace {

/// A kind of material: what becomes of its color and its index of refraction.
struct MaterialKind {
  std::string_view name;
  bool needs_index;  // above 0
  void (*fill)(Material&, const R2::Color& color, double index);
};

// Varnish, and most plastics. The course's files give their glossy surfaces an index of 1, which reflects nothing.
constexpr double usual_coat = 1.5;

// In the order of the course's enumeration, whose numbers are taken for the names.
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

}  // namespace

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

}  // namespace ray::comp30019
