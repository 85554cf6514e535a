#include "source/view/edit/ScnEdits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "R3/ShapeKind.h"
#include "source/parse/scn/QuotedName.h"
#include "source/scene/CameraText.h"
#include "source/scene/Light.h"
#include "source/text/Number.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr std::uint32_t top_file = 0;

/// Part of a text: [begin, end).
struct Range {
  std::size_t begin = 0, end = 0;
};

const ScnPlaces::File& FileOf(const ScnPlaces& places, std::uint32_t statement) {
  return places.files[places.statements[statement].file];
}

bool IsBlank(char c) { return c == ' ' || c == '\t'; }

/// Returns the line end of the file: of its first line, or LF if it has only one line.
std::string EndOfLine(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string_view::npos || text[end] == '\n') return "\n";
  return text.substr(end).starts_with("\r\n") ? "\r\n" : "\r";
}

/// Behind the end of the line that `at` is in.
std::size_t BehindLine(std::string_view text, std::size_t at) {
  const std::size_t end = text.find_first_of("\r\n", at);
  if (end == std::string_view::npos) return text.size();
  return text.substr(end).starts_with("\r\n") ? end + 2 : end + 1;
}

std::size_t SkipBlanks(std::string_view text, std::size_t at) {
  while (at < text.size() && IsBlank(text[at])) ++at;
  return at;
}

/// The start of the line if only blanks are between it and `at`; else `at`.
std::size_t StartOfLineBefore(std::string_view text, std::size_t at) {
  std::size_t start = at;
  while (start > 0 && IsBlank(text[start - 1])) --start;
  return start == 0 || EndsLine(text[start - 1]) ? start : at;
}

/// Returns true if only a comment follows on the line.
bool EndsItsLine(std::string_view text, std::size_t at) {
  at = SkipBlanks(text, at);
  return at == text.size() || EndsLine(text[at]) || text[at] == '#';
}

bool OpensGroup(const std::string& command) { return command == "begin" || command == "csg"; }

/// Returns the range from the command to its last word; for a group, to that of its end.
Range RangeOf(const ScnPlaces& places, std::uint32_t statement) {
  const ScnPlaces::Statement& own = places.statements[statement];
  int open = 0;
  for (std::uint32_t i = statement; i < places.statements.size(); ++i) {
    if (places.statements[i].file != own.file) continue;
    const std::string command = CommandOf(places, i);
    if (OpensGroup(command)) ++open;
    if (command == "end") --open;
    if (open == 0) return {own.begin, WordsOf(places, i).back().End()};
  }
  throw EditRefusal("its end is not in the file");
}

/// A range, widened to whole lines with their ends if these contain nothing else but comments; `is_whole` is then true.
struct WholeLines {
  Range range;
  bool is_whole = false;
};
WholeLines LinesOf(std::string_view text, const Range& range) {
  const std::size_t start = StartOfLineBefore(text, range.begin);
  const bool is_first = start == 0 || EndsLine(text[start - 1]);
  if (!is_first || !EndsItsLine(text, range.end)) return {range, false};
  return {{start, BehindLine(text, range.end)}, true};
}

/// Returns an edit for each number that changes, the last one first, so that offsets stay valid.
TextEdits WithNumbers(const ScnPlaces& places, std::uint32_t statement, const std::vector<std::size_t>& at,
                      const std::vector<double>& values) {
  const std::vector<ScnWord> words = WordsOf(places, statement);
  TextEdits edits;
  for (std::size_t i = at.size(); i-- > 0;) {
    const ScnWord& word = words.at(at[i]);
    if (ParseNumber(word.text).value == values[i]) continue;
    edits.push_back({FileOf(places, statement).canonical, word.begin, word.text, ToText(values[i])});
  }
  std::ranges::sort(edits, std::ranges::greater{}, &TextEdit::at);
  return edits;
}

std::string TranslationText(const R3::Vector& way) {
  return "translate " + ToText(Decimal(way.x)) + " " + ToText(Decimal(way.y)) + " " + ToText(Decimal(way.z));
}

/// A group around the whole statement.
TextEdits Grouped(const ScnPlaces& places, std::uint32_t statement, const R3::Vector& way) {
  const Range range = RangeOf(places, statement);
  const std::string& file = FileOf(places, statement).canonical;
  return {{file, range.end, "", "  end"}, {file, range.begin, "", "begin -1 " + TranslationText(way) + "  "}};
}

bool IsPlaced(const std::string& command) {
  return command == "line" || R3::FindShapeKind(command) || FindLightKind(command);
}

/// The text that can be moved, copied and removed.
bool IsThing(const std::string& command) {
  constexpr std::array others{"begin", "csg", "mesh", "quad", "polygon", "implicit"};
  return IsPlaced(command) || std::ranges::find(others, command) != others.end();
}

void RefuseOthers(const ScnPlaces& places, std::uint32_t statement, const char* verb) {
  const std::string command = CommandOf(places, statement);
  if (!IsThing(command)) throw EditRefusal("a " + command + " cannot be " + verb);
}

constexpr std::size_t word_of_texture = 18;  // of a material's statement, the last

/// Returns the number of the material in its file.
std::size_t IdOf(const ScnPlaces& places, std::size_t material) {
  const ScnPlaces::Statement& own = places.statements[places.materials[material]];
  std::set<std::uint32_t> before;  // where those before it begin; of a file that is included twice all come again
  for (const std::uint32_t statement : places.materials) {
    if (statement == ScnPlaces::nowhere) continue;
    const ScnPlaces::Statement& other = places.statements[statement];
    if (other.file == own.file && other.begin < own.begin) before.insert(other.begin);
  }
  return before.size();
}

double Number(const ScnWord& word) { return ParseNumber(word.text).value; }

/// The words of a camera of 12 numbers.
std::vector<double> NumbersOf(const Camera& c) {
  return {c.eye.x, c.eye.y, c.eye.z, c.towards.x, c.towards.y, c.towards.z, c.up.x, c.up.y, c.up.z, c.xfov};
}

/// Returns the numbers after look_at for this camera, at the same distance from the target as before; std::nullopt if
/// no such numbers give exactly this camera.
std::optional<std::vector<double>> LookAtNumbersOf(const Camera& camera, const std::vector<ScnWord>& words) {
  constexpr std::size_t eye = 2, target = 5, count = 12;
  if (words.size() < count) return {};
  const auto along = [&](std::size_t axis) { return Number(words[target + axis]) - Number(words[eye + axis]); };
  const R3::Vector before{along(0), along(1), along(2)};
  const R3::Point at = camera.eye + Length(before) * camera.towards;
  Camera read = Aim(camera.eye, at - camera.eye, camera.up).camera;
  read.SetFov(camera.Fov());
  read.TakeViewOf(camera);
  read.near = camera.near, read.far = camera.far;
  if (CameraLine(read) != CameraLine(camera)) return {};
  return std::vector{camera.eye.x, camera.eye.y, camera.eye.z, at.x,        at.y,
                     at.z,         camera.up.x,  camera.up.y,  camera.up.z, camera.Fov()};
}

/// "camera" and 12 numbers.
std::string TwelveNumbers(const Camera& camera) {
  Camera plain = camera;
  plain.kind = &pinhole_camera, plain.extent = 0, plain.aspect = 0, plain.shift = {0, 0};
  if (plain.IsMirrored()) plain.right = -plain.right;
  return CameraLine(plain);
}

/// Inserts a line after the last one of the statement, or at the end of the top file.
TextEdits WithLine(const ScnPlaces& places, std::optional<std::uint32_t> behind, const std::string& line) {
  const ScnPlaces::File& file = places.files[top_file];
  const std::string& text = file.text->bytes;
  const std::string end = EndOfLine(text);
  const std::size_t at = behind ? BehindLine(text, RangeOf(places, *behind).end) : text.size();
  const bool is_ended = at == 0 || EndsLine(text[at - 1]);
  return {{file.canonical, at, "", (is_ended ? "" : end) + line + end}};
}

TextEdits WithSetting(const ScnPlaces& places, const std::string& option, const std::string& value) {
  for (auto i = static_cast<std::uint32_t>(places.statements.size()); i-- > 0;) {
    if (CommandOf(places, i) != "set") continue;
    const std::vector<ScnWord> words = WordsOf(places, i);
    if (words.size() < 2 || words[1].text != option) continue;
    if (words.size() != 3 || !WhyComputed(words[2].text).empty())
      throw EditRefusal("'set " + option + "' is not a plain number in the file");
    if (words[2].text == value) return {};
    return {{FileOf(places, i).canonical, words[2].begin, words[2].text, value}};
  }
  return WithLine(places, LastOf(places, "camera"), "set " + option + " " + value);
}

}  // namespace

double Decimal(double value) {
  constexpr int digits = 12;
  return ParseNumber(Rounded(value, digits)).value;
}

TextEdits WithValues(const ScnPlaces& places, std::uint32_t statement, const ScnField& field,
                     const std::vector<double>& values) {
  if (!field.problem.empty()) throw EditRefusal(field.name + ": " + field.problem);
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
    throw EditRefusal(field.name + " must be a number");
  return WithNumbers(places, statement, field.words, values);
}

TextEdits Moved(const ScnPlaces& places, std::uint32_t statement, const R3::Vector& way) {
  RefuseOthers(places, statement, "moved");
  std::vector<std::size_t> at;
  std::vector<double> values;
  for (const ScnField& field : FieldsOf(places, statement)) {
    if (field.kind != ScnField::Kind::point) continue;
    if (!field.problem.empty()) throw EditRefusal(field.name + ": " + field.problem);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at.push_back(field.words[axis]);
      const double step = way[static_cast<int>(axis)];
      values.push_back(step == 0 ? field.values[axis] : Decimal(field.values[axis] + step));
    }
  }
  if (!at.empty()) return WithNumbers(places, statement, at, values);
  const std::vector<ScnWord> words = WordsOf(places, statement);
  constexpr std::size_t placement = 2;
  const std::string command = CommandOf(places, statement);
  if (FindLightKind(command)) throw EditRefusal("a " + command + " has no place");
  if (command == "begin" && words.size() > placement)
    return {{FileOf(places, statement).canonical, words[placement].begin, "", TranslationText(way) + " "}};
  return Grouped(places, statement, way);
}

TextEdits Removed(const ScnPlaces& places, std::uint32_t statement) {
  RefuseOthers(places, statement, "deleted");
  const ScnPlaces::File& file = FileOf(places, statement);
  const std::string& text = file.text->bytes;
  auto [range, is_whole] = LinesOf(text, RangeOf(places, statement));
  if (!is_whole) {
    const std::size_t behind = SkipBlanks(text, range.end);
    const bool others_follow = behind < text.size() && !EndsLine(text[behind]) && text[behind] != '#';
    if (others_follow)
      range.end = behind;
    else
      while (range.begin > 0 && IsBlank(text[range.begin - 1])) --range.begin;
  }
  return {{file.canonical, range.begin, text.substr(range.begin, range.end - range.begin), ""}};
}

Copied Duplicated(const ScnPlaces& places, std::uint32_t statement, const R3::Vector& way) {
  RefuseOthers(places, statement, "duplicated");
  const ScnPlaces::File& file = FileOf(places, statement);
  const std::string& text = file.text->bytes;
  const Range range = RangeOf(places, statement);
  const auto [lines, is_whole] = LinesOf(text, range);
  std::string copy = text.substr(lines.begin, lines.end - lines.begin);
  const TextEdits moves =
      FindLightKind(CommandOf(places, statement)) && way == R3::Vector{} ? TextEdits{} : Moved(places, statement, way);
  for (const TextEdit& edit : moves) copy.replace(edit.at - lines.begin, edit.before.size(), edit.after);
  std::string between = is_whole ? "" : "  ";
  if (is_whole && !(lines.end > 0 && EndsLine(text[lines.end - 1]))) between = EndOfLine(text);
  return {{{file.canonical, lines.end, "", between + copy}}, lines.end + between.size() + range.begin - lines.begin};
}

std::optional<std::uint32_t> LastOf(const ScnPlaces& places, const std::string& command) {
  for (auto i = static_cast<std::uint32_t>(places.statements.size()); i-- > 0;)
    if (places.statements[i].file == top_file && CommandOf(places, i) == command) return i;
  return {};
}

TextEdits WithCamera(const ScnPlaces& places, const Camera& camera) {
  const auto statement = LastOf(places, "camera");
  if (!statement) {
    for (std::uint32_t i = 0; i < places.statements.size(); ++i)
      if (CommandOf(places, i) == "camera")
        throw EditRefusal("the camera is in " + FileOf(places, i).text->name + ", which is included");
    return WithLine(places, {}, TwelveNumbers(camera));
  }
  const std::vector<ScnWord> words = WordsOf(places, *statement);
  for (const ScnWord& word : words)
    if (const std::string why = WhyComputed(word.text); !why.empty()) throw EditRefusal("the camera: " + why);
  const bool looks_at = words.size() > 1 && words[1].text == "look_at";
  const auto looking = looks_at ? LookAtNumbersOf(camera, words) : std::nullopt;
  if (looks_at && !looking) {
    const std::size_t begin = words.front().begin, size = words.back().End() - begin;
    const std::string& file = FileOf(places, *statement).canonical;
    return {{file, begin, FileOf(places, *statement).text->bytes.substr(begin, size), TwelveNumbers(camera)}};
  }
  const std::vector<double> numbers = looking ? *looking : NumbersOf(camera);
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < numbers.size(); ++i) at.push_back(i + (looks_at ? 2 : 1));
  return WithNumbers(places, *statement, at, numbers);
}

TextEdits WithSettings(const ScnPlaces& places, const std::vector<std::pair<std::string, std::string>>& settings) {
  TextEdits edits;
  for (const auto& [option, value] : settings)
    for (const TextEdit& edit : WithSetting(places, option, value))
      edits.push_back({edit.file, OffsetAfter(edits, edit.file, edit.at), edit.before, edit.after});
  return edits;
}

std::optional<std::uint32_t> AboutMaterial(const ScnPlaces& places, std::size_t material, const std::string& command) {
  const std::uint32_t file = places.statements[places.materials[material]].file;
  const std::string id = std::to_string(IdOf(places, material));
  for (auto i = static_cast<std::uint32_t>(places.statements.size()); i-- > 0;) {
    if (places.statements[i].file != file || CommandOf(places, i) != command) continue;
    const std::vector<ScnWord> words = WordsOf(places, i);
    if (words.size() > 1 && words[1].text == id) return i;
  }
  return {};
}

TextEdits WithAboutMaterial(const ScnPlaces& places, std::size_t material, const std::string& command,
                            const std::string& numbers) {
  return WithLine(places, places.materials[material],
                  command + " " + std::to_string(IdOf(places, material)) + " " + numbers);
}

std::string TextureOf(const ScnPlaces& places, std::size_t material) {
  const std::vector<ScnWord> words = WordsOf(places, places.materials[material]);
  if (words.size() <= word_of_texture || words[word_of_texture].text == "0") return {};
  return Unquoted(words[word_of_texture].text).name;
}

TextEdits WithTexture(const ScnPlaces& places, std::size_t material, const std::string& name) {
  const std::uint32_t statement = places.materials[material];
  const std::vector<ScnWord> words = WordsOf(places, statement);
  if (words.size() <= word_of_texture) throw EditRefusal("the material's line is not whole");
  const ScnWord& word = words[word_of_texture];
  if (const std::string why = WhyComputed(word.text); !why.empty()) throw EditRefusal(why);
  const std::string now = name.empty() || name == "0" ? "0" : QuotedWhereNeeded(name);
  if (now == word.text) return {};
  return {{FileOf(places, statement).canonical, word.begin, word.text, now}};
}

}  // namespace ray
