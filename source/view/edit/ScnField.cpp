#include "source/view/edit/ScnField.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "R3/ShapeKind.h"
#include "source/scene/Light.h"
#include "source/text/Number.h"

namespace ray {
namespace {

using Kind = ScnField::Kind;

struct NamedField {
  const char* name;
  Kind kind;
  std::size_t first;  // word
};

constexpr std::array material_fields{
    NamedField{"ambient (ka)", Kind::color, 1},       NamedField{"diffuse (kd)", Kind::color, 4},
    NamedField{"specular (ks)", Kind::color, 7},      NamedField{"transmission (kt)", Kind::color, 10},
    NamedField{"emission (ke)", Kind::color, 13},     NamedField{"shininess (n)", Kind::number, 16},
    NamedField{"refraction index", Kind::number, 17},
};
constexpr std::array camera_fields{
    NamedField{"eye", Kind::point, 1},
    NamedField{"view direction", Kind::direction, 4},
    NamedField{"up", Kind::direction, 7},
    NamedField{"half angle, radians", Kind::number, 10},
};
constexpr std::array look_at_fields{
    NamedField{"eye", Kind::point, 2},
    NamedField{"looks at", Kind::point, 5},
    NamedField{"up", Kind::direction, 8},
    NamedField{"whole angle, degrees", Kind::number, 11},
};
constexpr std::array mirror_fields{NamedField{"mirror (kr)", Kind::color, 2}};
constexpr std::array gloss_fields{NamedField{"gloss exponent", Kind::number, 2},
                                  NamedField{"gloss samples", Kind::number, 3}};
constexpr std::array color_fields{NamedField{"color", Kind::color, 1}};
constexpr std::array line_fields{NamedField{"from", Kind::point, 2}, NamedField{"to", Kind::point, 5}};

/// The names of single numbers, and of the first of three, in scene files and in panels.
struct Wording {
  std::string_view argument;
  const char* words;
};
constexpr std::array wordings{
    Wording{"r", "color"},           Wording{"px", "position"},      Wording{"cx", "center"},
    Wording{"dx", "direction"},      Wording{"nx", "normal"},        Wording{"x", "low corner"},
    Wording{"X", "high corner"},     Wording{"x1", "corner 1"},      Wording{"x2", "corner 2"},
    Wording{"x3", "corner 3"},       Wording{"ca", "constant (ca)"}, Wording{"la", "linear (la)"},
    Wording{"qa", "quadratic (qa)"}, Wording{"sc", "cutoff (sc)"},   Wording{"sd", "dropoff (sd)"},
};

std::string TextOf(std::string_view argument) {
  const auto found = std::ranges::find(wordings, argument, &Wording::argument);
  return found == wordings.end() ? std::string(argument) : found->words;
}

/// "cy" for "cx" and 'y'. Names of corners hold the letter before a number.
std::string WithLetter(std::string name, char x, char letter) {
  std::ranges::replace(name, x, letter);
  return name;
}

/// Returns true if three arguments from `i` on are the coordinates of one thing.
bool IsTriple(std::span<const R3::Argument> arguments, std::size_t i) {
  if (i + 2 >= arguments.size()) return false;
  const std::string first = arguments[i].name;
  const auto follow = [&](char x, char y, char z) {
    return first.find(x) != std::string::npos && WithLetter(first, x, y) == arguments[i + 1].name &&
           WithLetter(first, x, z) == arguments[i + 2].name;
  };
  return follow('x', 'y', 'z') || follow('X', 'Y', 'Z') || (first == "r" && follow('r', 'g', 'b'));
}

Kind KindOfTriple(std::string_view first) {
  if (first == "r") return Kind::color;
  return first == "dx" || first == "nx" ? Kind::direction : Kind::point;
}

/// `first`: the word of the first argument.
std::vector<ScnField> FieldsOfArguments(std::span<const R3::Argument> arguments, std::size_t first) {
  std::vector<ScnField> fields;
  for (std::size_t i = 0; i < arguments.size();) {
    ScnField field{TextOf(arguments[i].name), Kind::number, {first + i}, {}, {}};
    if (IsTriple(arguments, i)) {
      field.kind = KindOfTriple(arguments[i].name);
      field.words = {first + i, first + i + 1, first + i + 2};
    }
    i += field.words.size();
    fields.push_back(std::move(field));
  }
  return fields;
}

std::vector<ScnField> FieldsOfTable(std::span<const NamedField> table) {
  std::vector<ScnField> fields;
  for (const NamedField& named : table) {
    ScnField field{named.name, named.kind, {named.first}, {}, {}};
    if (named.kind != Kind::number) field.words = {named.first, named.first + 1, named.first + 2};
    fields.push_back(std::move(field));
  }
  return fields;
}

/// The position of a group: the last column of its matrix, or the translation that stands first.
std::vector<ScnField> FieldsOfGroup(const std::vector<ScnWord>& words) {
  constexpr std::size_t placement = 2, entries = 16;  // its first word, and the numbers of a matrix
  const bool is_translation = words.size() > placement + 3 && words[placement].text == "translate";
  if (is_translation) return {{"position", Kind::point, {placement + 1, placement + 2, placement + 3}, {}, {}}};
  const bool is_matrix = words.size() >= placement + entries &&
                         (!ParseNumber(words[placement].text).problem || !WhyComputed(words[placement].text).empty());
  if (is_matrix) return {{"position", Kind::point, {placement + 3, placement + 7, placement + 11}, {}, {}}};
  return {};
}

std::vector<ScnField> UnreadFields(const std::string& name, const std::vector<ScnWord>& words) {
  constexpr std::size_t behind_command = 1, behind_material = 2;
  if (name == "material") return FieldsOfTable(material_fields);
  if (name == "mirror") return FieldsOfTable(mirror_fields);
  if (name == "gloss") return FieldsOfTable(gloss_fields);
  if (name == "line") return FieldsOfTable(line_fields);
  if (name == "begin") return FieldsOfGroup(words);
  if (name == "background" || name == "ambient") return FieldsOfTable(color_fields);
  if (name == "camera") {
    const bool looks_at = words.size() > 1 && words[1].text == "look_at";
    return looks_at ? FieldsOfTable(look_at_fields) : FieldsOfTable(camera_fields);
  }
  if (const auto* shape = R3::FindShapeKind(name)) return FieldsOfArguments(shape->arguments, behind_material);
  if (const auto* light = FindLightKind(name)) return FieldsOfArguments(light->arguments, behind_command);
  return {};
}

void ReadValues(const std::vector<ScnWord>& words, ScnField& field) {
  for (const std::size_t i : field.words) {
    const std::string word = i < words.size() ? words[i].text : "";
    const auto [value, problem] = ParseNumber(word);
    field.values.push_back(problem ? 0 : value);
    if (!problem || !field.problem.empty()) continue;
    field.problem = WhyComputed(word);
    if (field.problem.empty()) field.problem = "it is no plain number in the file";
  }
}

}  // namespace

std::vector<ScnField> FieldsOf(const ScnPlaces& places, std::uint32_t statement) {
  const std::vector<ScnWord> words = WordsOf(places, statement);
  if (words.empty()) return {};
  std::vector<ScnField> fields = UnreadFields(CommandOf(places, statement), words);
  for (ScnField& field : fields) ReadValues(words, field);
  return fields;
}

std::string WhyComputed(const std::string& word) {
  if (word.starts_with('$')) return word + " is a variable; edit its 'define' in the file";
  if (word.starts_with('(')) return word + " is a formula; edit it in the file";
  return {};
}

std::string CommandOf(const ScnPlaces& places, std::uint32_t statement) {
  const ScnPlaces::Statement& own = places.statements[statement];
  const std::string_view text = std::string_view(places.files[own.file].text->bytes).substr(own.begin);
  const auto end = std::ranges::find_if(text, [](char c) { return IsSpace(c) || c == '#'; });
  return {text.begin(), end};
}

std::string NameOf(const ScnPlaces& places, std::uint32_t statement) {
  const ScnPlaces::Statement& own = places.statements[statement];
  return CommandOf(places, statement) + ", line " + std::to_string(LocationAt(places, own.file, own.begin).line);
}

std::string CommentOf(const ScnPlaces& places, std::uint32_t statement) {
  const std::vector<ScnWord> words = WordsOf(places, statement);
  if (words.empty()) return {};
  std::string_view rest = places.files[places.statements[statement].file].text->bytes;
  rest = rest.substr(words.back().End());
  rest = rest.substr(0, rest.find_first_of("\r\n"));
  constexpr std::string_view blanks = " \t";
  const std::size_t hash = rest.find_first_not_of(blanks);
  if (hash == std::string_view::npos || rest[hash] != '#') return {};
  rest = rest.substr(hash);
  const std::size_t first = rest.find_first_not_of("# \t");
  if (first == std::string_view::npos) return {};
  return std::string(rest.substr(first, rest.find_last_not_of(blanks) + 1 - first));
}

}  // namespace ray
