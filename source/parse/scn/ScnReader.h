#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "R3/Shape.h"
#include "source/parse/Assets.h"
#include "source/parse/Files.h"
#include "source/parse/Parse.h"
#include "source/parse/SceneBuilder.h"
#include "source/parse/SceneError.h"
#include "source/parse/Tokenizer.h"
#include "source/parse/scn/ScnPlaces.h"
#include "source/parse/scn/Statement.h"

namespace ray {

/// A reader of scenes in the course's .scn language (spring 2008 and 2011; see the manual). Its statements are the
/// table in Command.h; this class has their shared state: the files being read, innermost last, and the scene under
/// construction.
class ScnReader {
 public:
  ScnReader(const Files& files, const ParseOptions& options, Assets& assets, Report& report);

  /// Reads the top scene to its end. Mistakes go to the report.
  Scene Read();

  // For commands, while their statement is read:

  /// Reads a material id; returns an index into Scene::materials, or Node::inherit. At the top level of an included
  /// file, inheriting means the default material and not the enclosing group's, as in the course's reader.
  int ReadMaterial(Statement& statement);
  Variables& Definitions() { return variables_; }
  /// Returns true if that material is the default one here, since no enclosing group sets another.
  bool IsDefaultGray(int material) const;
  /// Returns a material that the file itself has defined, to be modified; null after an error.
  Material* ReadOwnMaterial(Statement& statement);
  /// Returns the material of the file's next id, to be filled in; valid until the next call.
  Material& NewMaterial();
  void AddNode(Statement& statement, Node node);
  /// Adds a shape; warns if no ray can hit it.
  void AddShape(Statement& statement, int material, std::shared_ptr<const R3::Shape> shape);
  void OpenGroup(Statement& statement, Node group);
  void CloseGroup(Statement& statement);
  /// Returns the group that this file opened last and has not closed; null at its top level.
  Node* InnermostGroup();
  /// Continues with another file; the words after this statement follow its end.
  void Include(Statement& statement, const FileWord& named);
  /// Returns "room.scn:12:3".
  std::string PlaceOf(const Token& word) const { return Place(CurrentFile(), word.line, word.column); }
  /// Returns the problem with a setting; std::nullopt if a scene may make it.
  std::optional<SettingProblem> ProblemOf(const SceneSetting& setting) const {
    return options_.problem_of ? options_.problem_of(setting) : std::nullopt;
  }
  /// Records a camera in the current file. Returns true if the scene already has one that is not in a file included by
  /// this one: cameras of included files are meant to be overridden.
  bool ReplacesCamera();
  /// Adds a warning about the statement.
  void Warn(const Statement& statement, const std::string& message);
  /// Calls `read`, a function that reads the file named by the word `name`, and converts its errors to errors of the
  /// statement.
  void WithFile(Statement& statement, const Token& name, const std::function<void()>& read);

  Assets& Library() { return assets_; }
  SceneBuilder& Builder() { return builder_; }
  const std::string& CurrentFile() const { return open_files_.back().text->name; }

 private:
  struct OpenFile {
    std::shared_ptr<const Text> text;
    std::string canonical;
    std::uint32_t index;       // into Scene::files
    std::size_t outer_groups;  // number of open groups of the enclosing files
    Tokenizer tokens;
    std::vector<int> materials{};  // own id -> index into Scene::materials
    std::vector<Token> begins{};   // of the groups this file has open
    Token statement{};             // the last one; the include while an included file is open
    const Command* last_command = nullptr;
  };

  struct KnownText {
    std::shared_ptr<const Text> text;
    std::uint32_t index;  // into Scene::files
  };

  void Open(const FoundFile& file);
  KnownText TextOf(const FoundFile& file);
  /// Returns the edited text of the file, or that on disk. Throws FileError.
  std::string BytesOf(const FoundFile& file) const;
  void CloseFile();
  void ReadStatement(Token word);
  void BeginPlace(const Token& word);
  void EndPlace(const Command& command);
  void UnknownCommand(const Token& word);
  void CheckNodes(const Statement& statement);
  void Error(SceneError error);
  [[noreturn]] void Stop(SceneError error);
  OpenFile& Current() { return open_files_.back(); }

  const Files& files_;
  const ParseOptions& options_;
  Variables variables_;
  Report& report_;
  Assets& assets_;
  SceneBuilder builder_;
  std::deque<OpenFile> open_files_;  // a deque, so that opening a file does not move the one with the include
  std::map<std::string, KnownText> texts_;
  std::size_t camera_depth_ = 0;  // number of files open around the last camera
  std::size_t includes_ = 0;
  std::size_t bytes_ = 0;  // of text read, counting an included file each time
};

}  // namespace ray
