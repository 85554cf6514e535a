#include "source/parse/courses/comp30019/Reader.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "R3/ShapeKind.h"
#include "source/parse/Coordinate.h"
#include "source/parse/Format.h"
#include "source/parse/courses/comp30019/View.h"
#include "source/parse/scn/Command.h"
#include "source/text/LowerCase.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace comp30019 {
namespace {

// The course's rules that no file can change. Its reference images match a recursion of 8 to 10 bounces best. Each
// emissive entity is one light with the full color of its material; the course states this for spheres and triangles,
// but not for models. Ambient light, which mode path traces, adds to that.
constexpr std::array rules{
    std::pair{"width", "400"},  std::pair{"height", "400"},      std::pair{"sampler", "grid"},
    std::pair{"samples", "1"},  std::pair{"max_depth", "10"},    std::pair{"min_luminance", "0"},
    std::pair{"fresnel", "on"}, std::pair{"bytes", "truncated"}, std::pair{"emissive_solids", "on"},
    std::pair{"emissive_meshes", "whole"}, std::pair{"emission", "color"},
};

constexpr std::size_t most_suggested = 100;  // materials; longer lists are useless and slow to compare with

// Words that begin lines of the language of 2025.
constexpr std::array<std::string_view, 5> later_commands{"Camera", "TextureMaterial", "ProceduralMaterial",
                                                         "SimpleAnimation", "KeyFrame"};

const char* NounOf(Reader::Space space) {
  switch (space) {
    case Reader::Space::material:
      return "material";
    case Reader::Space::light:
      return "light";
    case Reader::Space::entity:
      return "entity";
  }
  return "";
}

/// Returns the name of a material if the line begins as: Material "name"
const Token* NameOfMaterial(std::span<const Token> line) {
  const bool is_one = line.size() > 3 && line[0].text == "Material" && line[1].text == "\"" && line[3].text == "\"";
  return is_one ? &line[2] : nullptr;
}

/// Returns the token that only the later edition would have: a command of its own, or the colors that its materials
/// have in place of a kind.
const Token* SignOfLaterEdition(std::span<const Token> line) {
  if (std::ranges::find(later_commands, line[0].text) != later_commands.end()) return &line[0];
  return NameOfMaterial(line) && line.size() > 4 && line[4].text == "(" ? &line[4] : nullptr;
}

void CheckCoordinate(Line& line, const Number& x, const char* what) {
  if (!IsCoordinate(x.value))
    line.Error(x.token, std::string(what) + " must not exceed 1e150 in magnitude, got " + Escaped(x.token.text));
}

std::vector<SceneSetting> Rules() {
  std::vector<SceneSetting> settings;
  for (const auto& [option, value] : rules) settings.push_back({option, value, "COMP30019"});
  return settings;
}

Scene ReadComp30019(const Files& files, const ParseOptions& options, Assets& assets, Report& report) {
  return Reader(files, options, assets, report).Read();
}

}  // namespace

Reader::Reader(const Files& files, const ParseOptions& options, Assets& assets, Report& report)
    : files_(files), options_(options), report_(report), assets_(assets) {}

Scene Reader::Read() {
  builder_.has_camera = builder_.has_light = true;  // the course has no default camera or lights
  builder_.scene.camera = ViewFrom({}, {}, 0);
  builder_.scene.is_mirrored = true;
  builder_.scene.settings = Rules();
  builder_.scene.files.push_back(files_.TopName());
  try {
    text_ = {files_.TopName(), files_.Read(files_.Top())};
    if (auto error = FindNul(text_)) throw std::move(*error);
    ReadLines();
  } catch (const FileError& error) {
    report_.Error(ErrorIn(files_.TopName(), error.message, error.hint));
  } catch (SceneError& error) {
    report_.Error(std::move(error));
  }
  auto& files = builder_.scene.files;
  files.insert(files.end(), assets_.FilesRead().begin(), assets_.FilesRead().end());
  return builder_.Finish();
}

void Reader::ReadLines() {
  const auto lines = TokensByLine(text_);
  for (const auto& line : lines)
    if (const Token* sign = SignOfLaterEdition(line))
      throw ErrorAt(text_, *sign, "this is the language of a later edition of COMP30019 (2025)",
                    "raypro reads that of 2021 and 2022");
  for (const auto& line : lines)
    if (const Token* name = NameOfMaterial(line)) lines_of_materials_.emplace(name->text, name->line);
  for (const auto& line : lines) ReadLine(line);
}

void Reader::ReadLine(std::span<const Token> tokens) {
  const Command* command = FindCommand(tokens[0].text);
  if (!command) return UnknownCommand(tokens[0]);
  Line line(text_, tokens, std::string(command->usage));
  try {
    command->read(*this, line);
    if (const auto rest = line.Rest(); line.IsGood() && !rest.empty())
      Warn(rest[0], Quoted(rest[0].text) + " and what follows on this line is ignored: " + std::string(command->usage));
  } catch (const Line::Incomplete&) {
    // The missing argument is among its errors.
  }
  for (SceneError& error : std::move(line).Errors()) report_.Error(std::move(error));
}

void Reader::UnknownCommand(const Token& word) {
  const bool is_comment = word.text.starts_with('#') || word.text.starts_with("//");
  const auto is_meant = [&](std::string_view name) { return LowerCase(std::string(name)) == word.text; };
  const bool is_of_scn = ray::FindCommand(word.text) && std::ranges::none_of(CommandNames(), is_meant);
  report_.Error(ErrorAt(text_, word, "unknown command " + Quoted(word.text),
                        is_comment  ? "this language has no comments"
                        : is_of_scn ? "it is one of .scn, which -format scn reads"
                                    : Suggestion(word.text, CommandNames(), "commands")));
}

Token Reader::Declare(Space space, Line& line) {
  const Token name = line.Name("name");
  const auto [first, is_new] = taken_[space].emplace(name.text, name.line);
  if (!is_new)
    line.Error(name, std::string(NounOf(space)) + " " + Quoted(name.text) + " exists already",
               "it is on line " + std::to_string(first->second));
  return name;
}

Material& Reader::NewMaterial(Line& line) {
  // Reserved first, so that a material with mistakes also has its name, and no further error is reported where it is
  // used.
  auto& materials = builder_.scene.materials;
  materials_.emplace(Declare(Space::material, line).text, static_cast<int>(materials.size()));
  return materials.emplace_back();
}

int Reader::ReadMaterial(Line& line) {
  const Token name = line.Name("material");
  const auto known = materials_.find(name.text);
  if (known != materials_.end()) return known->second;
  line.Error(name, "no material " + Quoted(name.text), WhyUnknown(name));
  return 0;
}

std::string Reader::WhyUnknown(const Token& material) const {
  if (const auto later = lines_of_materials_.find(material.text); later != lines_of_materials_.end())
    return "it is defined on line " + std::to_string(later->second) + ", which must come first";
  if (materials_.empty()) return "no material is defined before this line";
  if (materials_.size() > most_suggested) return {};
  std::vector<std::string_view> names;
  for (const auto& [name, index] : materials_) names.push_back(name);
  return Escaped(Suggestion(material.text, names, "materials"));
}

Number Reader::ReadCoordinate(Line& line, const char* what) {
  const Number x = line.Real(what);
  CheckCoordinate(line, x, what);
  return x;
}

Triple Reader::ReadPoint(Line& line, const char* what) {
  const Triple point = line.Vector(what, "xyz");
  for (const Number& x : point) CheckCoordinate(line, x, what);
  return point;
}

Triple Reader::ReadColor(Line& line, const char* what) {
  const Triple color = line.Vector(what, "rgb");
  for (const Number& part : color)
    if (part.value < 0)
      line.Error(part.token, std::string(what) + " must not be negative, got " + Escaped(part.token.text));
  return color;
}

void Reader::AddLight(const char* kind, const std::vector<double>& numbers) {
  builder_.scene.lights.push_back(FindLightKind(kind)->make(numbers));
}

void Reader::AddShape(const Line& line, const char* kind, const std::vector<double>& numbers, int material) {
  CheckNodes(line);
  Node node;
  node.shape = R3::FindShapeKind(kind)->make(numbers);
  if (node.shape->IsDegenerate())
    Warn(line.Command(), "degenerate " + std::string(line.Command().text) + ": no ray can hit it");
  node.material = material;
  node.location = LocationOf(0, line.Command());
  SetBounds(node);
  builder_.Add(std::move(node));
}

void Reader::AddModel(Line& line, const Token& file, const R3::Point& offset, double scale, int material) {
  // The course's program searches relative to its working folder; here the scene's folder and its parent follow,
  // because the course's scenes are in tests/, and name tests/models/bunny.obj.
  const std::filesystem::path folder = std::filesystem::path(files_.TopName()).parent_path();
  const std::array folders{std::string(), folder.string(), (folder / "..").string()};
  Node model;
  try {
    const auto boxed =
        assets_.MeshOf(files_.FindIn(folders, std::string(file.text)), {Assets::Shading::Normals::of_file});
    model.shape = boxed.mesh;
    model.bounds = boxed.bounds;
  } catch (const FileError& error) {
    line.Error(file, error.message,
               error.hint.empty() ? "searched the current folder, the scene's folder and its parent" : error.hint);
  } catch (SceneError& error) {
    error.included_from.push_back(text_.name + ":" + std::to_string(file.line));
    report_.Error(std::move(error));
  }
  if (!model.shape || !line.IsGood()) return;
  CheckNodes(line);
  Node placed;
  placed.transform.m = {{{scale, 0, 0, offset.x}, {0, scale, 0, offset.y}, {0, 0, scale, offset.z}}};
  placed.material = model.material = material;
  placed.location = model.location = LocationOf(0, line.Command());
  builder_.OpenGroup(std::move(placed));
  builder_.Add(std::move(model));
  builder_.CloseGroup();
}

void Reader::Warn(const Token& at, const std::string& message) {
  report_.Warn(Place(files_.TopName(), at.line, at.column), message);
}

void Reader::CheckNodes(const Line& line) {
  if (builder_.nodes < options_.max_nodes) return;
  report_.Error(
      ErrorAt(text_, line.Command(), "the scene has more than " + std::to_string(options_.max_nodes) + " nodes"));
  report_.ThrowErrors();
}

}  // namespace comp30019

extern const SceneFormat comp30019_scene_format{
    .name = "comp30019",
    .extensions = {".txt"},
    .about = "COMP30019, Graphics and Interaction, University of Melbourne (2021, 2022)",
    .read = comp30019::ReadComp30019,
};

}  // namespace ray
