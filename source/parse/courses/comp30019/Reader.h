#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "source/parse/Assets.h"
#include "source/parse/Files.h"
#include "source/parse/Parse.h"
#include "source/parse/SceneBuilder.h"
#include "source/parse/SceneError.h"
#include "source/parse/courses/comp30019/Line.h"

namespace ray::comp30019 {

class Reader;

/// A word that starts a line.
struct Command {
  std::string_view name;
  std::string_view usage;
  void (*read)(Reader&, Line&);
};

/// Returns the command with the given name, case-sensitive, or null.
const Command* FindCommand(std::string_view name);
std::span<const std::string_view> CommandNames();

/// Mirrors a point. The world of these scenes is left-handed, with z into the screen; ours is its mirror image, every z
/// negated, which loses nothing.
inline R3::Point Mirrored(const Triple& p) { return {p[0].value, p[1].value, 0 - p[2].value}; }
inline R2::Color ColorOf(const Triple& c) { return {c[0].value, c[1].value, c[2].value}; }

/// A reader of scenes in the language of COMP30019, Graphics and Interaction (2021 and 2022). Its lines are the table
/// of Commands; this class has their shared state: names, and the scene under construction.
class Reader {
 public:
  Reader(const Files& files, const ParseOptions& options, Assets& assets, Report& report);

  /// Reads the top scene to its end. Mistakes go to the report.
  Scene Read();

  // For commands, while their line is read:

  /// The namespaces: in each, a name may be used once.
  enum class Space { material, light, entity };
  /// Reads a new name; an error if it is taken.
  Token Declare(Space space, Line& line);
  /// Reads the name of a material defined on an earlier line, as an index into Scene::materials.
  int ReadMaterial(Line& line);
  /// Returns the material of a new name, to be filled in; valid until the next call.
  Material& NewMaterial(Line& line);
  /// Reads a coordinate; numbers too large for intersection are errors.
  Number ReadCoordinate(Line& line, const char* what);
  Triple ReadPoint(Line& line, const char* what);
  /// Reads a color; negative components are errors.
  Triple ReadColor(Line& line, const char* what);
  /// Adds a light or shape of a kind in lights.def or shapes.def, with the numbers of a .scn file.
  void AddLight(const char* kind, const std::vector<double>& numbers);
  void AddShape(const Line& line, const char* kind, const std::vector<double>& numbers, int material);
  /// Adds a mesh of a file, which is in a right-handed world like ours: scaled, then moved by `offset`.
  void AddModel(Line& line, const Token& file, const R3::Point& offset, double scale, int material);
  /// Adds a warning with the position of a token.
  void Warn(const Token& at, const std::string& message);

  const Material& MaterialAt(int index) const { return builder_.scene.materials[static_cast<std::size_t>(index)]; }

 private:
  void ReadLines();
  void ReadLine(std::span<const Token> tokens);
  void UnknownCommand(const Token& word);
  void CheckNodes(const Line& line);
  std::string WhyUnknown(const Token& material) const;

  const Files& files_;
  const ParseOptions& options_;
  Report& report_;
  Assets& assets_;
  SceneBuilder builder_;
  Text text_;
  std::map<std::string_view, std::size_t> lines_of_materials_;      // of the whole file
  std::map<std::string_view, int> materials_;                       // those so far: index into Scene::materials
  std::map<Space, std::map<std::string_view, std::size_t>> taken_;  // name -> line
};

}  // namespace ray::comp30019
