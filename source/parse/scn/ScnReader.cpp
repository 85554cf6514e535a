#include "source/parse/scn/ScnReader.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "source/parse/Format.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/scn/QuotedName.h"
#include "source/text/LowerCase.h"
#include "source/text/Number.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

// Files that include files twice may take forever to read; the first of these limits to be reached ends it.
constexpr std::size_t max_includes = 10'000;
constexpr std::size_t max_bytes = Files::max_bytes;

constexpr int default_material = 0;

std::string KnownMaterials(std::size_t count) {
  if (count == 0) return "no material is defined in this file before this line; -1 inherits";
  if (count == 1) return "this file defines only material 0 before this line";
  return "this file defines materials 0 to " + std::to_string(count - 1) + " before this line";
}

Scene ReadScn(const Files& files, const ParseOptions& options, Assets& assets, Report& report) {
  return ScnReader(files, options, assets, report).Read();
}

/// Throws for file extensions that cannot contain statements.
void RefuseOtherLanguage(const FoundFile& file) {
  if (MeshFormatForName(file.shown))
    throw FileError{"cannot include a mesh, " + QuotedPath(file.shown), "'mesh mat_id file' reads it"};
  const std::string extension = LowerCase(std::filesystem::path(file.shown).extension().string());
  const bool is_document = std::ranges::any_of(SceneFormats(), [&](const SceneFormat* format) {
    return format->read_document && std::ranges::find(format->extensions, extension) != format->extensions.end();
  });
  if (is_document)
    throw FileError{"cannot include " + QuotedPath(file.shown) + ": an include is a .scn file",
                    "raypro -convert writes a scene as .scn"};
}

}  // namespace

extern const SceneFormat scn_scene_format{
    .name = "scn",
    .extensions = {".scn"},
    .about = "COS426, Princeton (2008, 2011)",
    .read = ReadScn,
    .has_variables = true,
};

ScnReader::ScnReader(const Files& files, const ParseOptions& options, Assets& assets, Report& report)
    : files_(files), options_(options), variables_(options.definitions), report_(report), assets_(assets) {}

Scene ScnReader::Read() {
  const std::string top = files_.TopName();
  try {
    Open(files_.Top());
  } catch (const FileError& error) {
    Stop(ErrorIn(top, error.message, error.hint));
  } catch (SceneError& error) {
    Stop(std::move(error));
  }
  while (!open_files_.empty()) {
    if (const auto word = Current().tokens.Next())
      ReadStatement(*word);
    else
      CloseFile();
  }
  for (const std::string& name : variables_.Unused())
    report_.Warn(Escaped(top), "'-define " + name + "=...' has no effect: there is no '$" + name + "' in the scene");
  // After the scene files, so that the indices in locations remain valid.
  auto& files = builder_.scene.files;
  files.insert(files.end(), assets_.FilesRead().begin(), assets_.FilesRead().end());
  return builder_.Finish();
}

void ScnReader::Open(const FoundFile& file) {
  const auto [text, index] = TextOf(file);
  bytes_ += text->bytes.size();
  if (bytes_ > max_bytes) Stop(ErrorIn(text->name, "the scene's files together exceed 1 GiB"));
  open_files_.push_back(
      {text, file.canonical, index, builder_.open_groups.size(),
       Tokenizer(*text, Tokenizer::Comments::hash, Tokenizer::Joints::none, Tokenizer::Quotes::names, &variables_)});
}

ScnReader::KnownText ScnReader::TextOf(const FoundFile& file) {
  if (const auto known = texts_.find(file.canonical); known != texts_.end()) return known->second;
  auto text = std::make_shared<const Text>(Text{file.shown, BytesOf(file)});
  if (auto error = FindNul(*text)) throw std::move(*error);
  const auto index = static_cast<std::uint32_t>(builder_.scene.files.size());
  builder_.scene.files.push_back(file.shown);
  if (options_.places) options_.places->files.push_back({file.canonical, text});
  return texts_.emplace(file.canonical, KnownText{std::move(text), index}).first->second;
}

std::string ScnReader::BytesOf(const FoundFile& file) const {
  if (options_.edited)
    if (const auto edited = options_.edited->find(file.canonical); edited != options_.edited->end())
      return edited->second;
  return files_.Read(file);
}

void ScnReader::CloseFile() {
  OpenFile& file = Current();
  for (SceneError& error : file.tokens.TakeMistakes()) Error(std::move(error));
  if (const std::size_t open = file.begins.size(); open > 0) {
    const std::string count = open == 1 ? "" : "the innermost of " + std::to_string(open) + " unclosed groups";
    Error(ErrorAt(*file.text, file.begins.back(), std::string(file.begins.back().text) + " without end", count));
  }
  while (builder_.open_groups.size() > file.outer_groups) builder_.CloseGroup();
  open_files_.pop_back();
}

void ScnReader::ReadStatement(Token word) {
  OpenFile& file = Current();
  const Command* command = FindCommand(word.text);
  if (const std::size_t hash = word.text.find('#'); !command && hash != std::string_view::npos) {
    // A comment directly after a command, as "end#close": other words may be names of files, where # is a letter.
    command = FindCommand(word.text.substr(0, hash));
    if (command) {
      word.text = word.text.substr(0, hash);
      file.tokens.SkipLine(word.line);
    }
  }
  if (!command) return UnknownCommand(word);
  file.last_command = command;
  file.statement = word;
  if (options_.places) BeginPlace(word);
  Statement statement(*command, word, file.tokens);
  try {
    command->read(*this, statement);
  } catch (const Statement::Incomplete&) {
    // The missing argument is among its errors.
  }
  if (options_.places) EndPlace(*command);
  for (SceneError& error : std::move(statement).Errors()) Error(std::move(error));
}

void ScnReader::BeginPlace(const Token& word) {
  const OpenFile& file = Current();
  const auto begin = static_cast<std::uint32_t>(word.InFile().data() - file.text->bytes.data());
  options_.places->statements.push_back({file.index, begin});
  options_.places->materials.resize(builder_.scene.materials.size(), ScnPlaces::nowhere);
}

/// The results of the statement are at the end of the scene's lists. A model's materials are from another file.
void ScnReader::EndPlace(const Command& command) {
  ScnPlaces& places = *options_.places;
  const auto statement = static_cast<std::uint32_t>(places.statements.size() - 1);
  const bool is_material = command.name == "material";
  places.materials.resize(builder_.scene.materials.size(), is_material ? statement : ScnPlaces::nowhere);
  places.lights.resize(builder_.scene.lights.size(), statement);
}

// One mistake, one report: the rest of the line, and numbers on the next lines, belong to the unknown command.
void ScnReader::UnknownCommand(const Token& word) {
  OpenFile& file = Current();
  const bool is_number = !ParseNumber(word.text).problem;
  if (is_number && file.last_command) {
    Error(ErrorAt(*file.text, word, "unexpected number " + Quoted(word.text), SurplusHint(*file.last_command)));
  } else if (const auto hint = ForeignHint(word.text); !hint.empty()) {
    Error(ErrorAt(*file.text, word, Quoted(word.text) + " is a command of another .scn dialect", std::string(hint)));
  } else {
    Error(ErrorAt(
        *file.text, word, "unknown command " + Quoted(word.text),
        word.text.starts_with("//") ? "a comment begins with #" : Suggestion(word.text, CommandNames(), "commands")));
  }
  if (!is_number) file.tokens.SkipLine(word.line);  // "particle_sink sphere ..." is not a sphere
  while (file.tokens.Peek() && !BeginsStatement(*file.tokens.Peek())) file.tokens.Next();
}

int ScnReader::ReadMaterial(Statement& statement) {
  const Token word = statement.Word("mat_id");
  const auto [id, problem] = ParseWhole(word.text);
  const std::vector<int>& known = Current().materials;
  if (problem) {
    statement.Error(word, std::string("mat_id ") + problem + ", got " + Quoted(word.text));
    return default_material;
  }
  if (id < 0) {
    const bool at_top_of_include = open_files_.size() > 1 && builder_.open_groups.size() == Current().outer_groups;
    return at_top_of_include ? default_material : Node::inherit;
  }
  if (id >= static_cast<std::int64_t>(known.size())) {
    statement.Error(word, "no material " + Escaped(word.text), KnownMaterials(known.size()));
    return default_material;
  }
  return known[static_cast<std::size_t>(id)];
}

bool ScnReader::IsDefaultGray(int material) const {
  if (material != Node::inherit) return material == default_material;
  return std::ranges::all_of(builder_.open_groups, [](const Node& group) {
    return group.material == Node::inherit || group.material == default_material;
  });
}

Node* ScnReader::InnermostGroup() { return Current().begins.empty() ? nullptr : &builder_.open_groups.back(); }

Material* ScnReader::ReadOwnMaterial(Statement& statement) {
  const int index = ReadMaterial(statement);
  if (!statement.IsGood()) return nullptr;
  const std::vector<int>& own = Current().materials;
  if (std::find(own.begin(), own.end(), index) == own.end()) {
    statement.Error(statement.CommandWord(),
                    statement.What().name + " needs a material defined in this file, not an inherited one");
    return nullptr;
  }
  return &builder_.scene.materials[static_cast<std::size_t>(index)];
}

Material& ScnReader::NewMaterial() {
  Current().materials.push_back(static_cast<int>(builder_.scene.materials.size()));
  return builder_.scene.materials.emplace_back();
}

void ScnReader::AddNode(Statement& statement, Node node) {
  CheckNodes(statement);
  node.location = LocationOf(Current().index, statement.CommandWord());
  if (builder_.IsInCsg())
    if (const auto fault = builder_.FaultOfCsg(node))
      return statement.Error(statement.CommandWord(), fault->message, fault->hint);
  builder_.Add(std::move(node));
}

void ScnReader::AddShape(Statement& statement, int material, std::shared_ptr<const R3::Shape> shape) {
  if (shape->IsDegenerate()) Warn(statement, "degenerate " + statement.What().name + ": no ray can hit it");
  Node node;
  node.material = material;
  node.shape = std::move(shape);
  SetBounds(node);
  AddNode(statement, std::move(node));
}

void ScnReader::OpenGroup(Statement& statement, Node group) {
  CheckNodes(statement);
  group.location = LocationOf(Current().index, statement.CommandWord());
  builder_.OpenGroup(std::move(group));
  Current().begins.push_back(statement.CommandWord());
}

void ScnReader::CloseGroup(Statement& statement) {
  OpenFile& file = Current();
  if (file.begins.empty()) {
    const bool is_included = open_files_.size() > 1;
    statement.Error(statement.CommandWord(), "end without begin",
                    is_included ? "an end can only close a begin of the same file" : "no group is open here");
    return;
  }
  const Token begin = file.begins.back();
  file.begins.pop_back();
  builder_.CloseGroup();
  const Node& closed = builder_.open_groups.back().children.back();
  if (closed.operation && closed.shape && closed.shape->IsDegenerate())
    report_.Warn(Place(CurrentFile(), begin.line, begin.column), "this csg is empty: no ray can hit it");
}

void ScnReader::Include(Statement& statement, const FileWord& named) {
  WithFile(statement, named.word, [&] {
    const FoundFile file = files_.Find(named.name, CurrentFile());
    RefuseOtherLanguage(file);
    const auto same = std::find_if(open_files_.begin(), open_files_.end(),
                                   [&](const OpenFile& open) { return open.canonical == file.canonical; });
    if (same != open_files_.end()) {
      std::string ring;
      for (auto open = same; open != open_files_.end(); ++open) ring += Escaped(open->text->name) + " -> ";
      throw FileError{"circular include", ring + Escaped(same->text->name)};
    }
    if (open_files_.size() > static_cast<std::size_t>(std::max(0, options_.include_depth)))
      throw FileError{"includes are nested deeper than " + std::to_string(options_.include_depth) + " files",
                      "-include_depth n allows more"};
    if (++includes_ > max_includes)
      Stop(ErrorAt(*Current().text, named.word, "more than " + std::to_string(max_includes) + " includes"));
    Open(file);
  });
}

void ScnReader::WithFile(Statement& statement, const Token& name, const std::function<void()>& read) {
  try {
    read();
  } catch (const FileError& error) {
    const std::string similar = QuotedWhereNeeded(error.similar);
    const bool needs_quotes = !error.similar.empty() && similar != error.similar;
    statement.Error(name, error.message, needs_quotes ? "did you mean " + Escaped(similar) + "?" : error.hint);
  } catch (SceneError& error) {
    error.included_from.push_back(CurrentFile() + ":" + std::to_string(name.line));
    Error(std::move(error));
  }
}

bool ScnReader::ReplacesCamera() {
  const std::size_t depth = open_files_.size(), before = std::exchange(camera_depth_, depth);
  return std::exchange(builder_.has_camera, true) && depth >= before;
}

void ScnReader::Warn(const Statement& statement, const std::string& message) {
  const Token& word = statement.CommandWord();
  report_.Warn(Place(CurrentFile(), word.line, word.column), message);
}

void ScnReader::CheckNodes(const Statement& statement) {
  if (builder_.nodes < options_.max_nodes) return;
  Stop(ErrorAt(*Current().text, statement.CommandWord(),
               "the scene has more than " + std::to_string(options_.max_nodes) + " nodes"));
}

void ScnReader::Error(SceneError error) {
  for (std::size_t i = open_files_.size(); i-- > 1;) {
    const OpenFile& outer = open_files_[i - 1];
    error.included_from.push_back(outer.text->name + ":" + std::to_string(outer.statement.line));
  }
  report_.Error(std::move(error));
}

void ScnReader::Stop(SceneError error) {
  Error(std::move(error));
  report_.ThrowErrors();
  std::abort();  // an error has just been reported
}

}  // namespace ray
