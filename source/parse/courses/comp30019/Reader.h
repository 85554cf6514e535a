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

/// A word that begins a line.
struct Command {
  std::string_view name;
  std::string_view usage;
  void (*read)(Reader&, Line&);
};

/// Null when there is none of that name; letter case counts.
const Command* FindCommand(std::string_view name);
std::span<const std::string_view> CommandNames();

/// The world of these scenes is left-handed, with z into the screen; ours is its mirror image, every z negated, which
/// loses nothing.
inline R3::Point Mirrored(const Triple& p) { return {p[0].value, p[1].value, 0 - p[2].value}; }
inline R2::Color ColorOf(const Triple& c) { return {c[0].value, c[1].value, c[2].value}; }

/// Reads a scene in the language of COMP30019, Graphics and Interaction (2021 and 2022). Its lines are the table of
/// Commands; this class keeps what they share: names, and the scene as it grows.
class Reader {
 public:
  Reader(const Files& files, const ParseOptions& options, Assets& assets, Report& report);

  /// Reads the top scene to its end. Mistakes go to the report.
  Scene Read();

  // For commands, while their line is read:

  /// The spaces of names: in each, a name may be given once.
  enum class Space { material, light, entity };
  /// A new name, an error where it is taken.
  Token Declare(Space space, Line& line);
  /// The name of a material defined on an earlier line, as an index into Scene::materials.
  int ReadMaterial(Line& line);
  /// The material of a new name, to be filled in; valid until the next.
  Material& NewMaterial(Line& line);
  /// Numbers beyond what can be intersected are errors.
  Number ReadCoordinate(Line& line, const char* what);
  Triple ReadPoint(Line& line, const char* what);
  /// Negative parts are errors.
  Triple ReadColor(Line& line, const char* what);
  /// Adds a light or shape of a kind in lights.def or shapes.def, with the numbers of a .scn file.
  void AddLight(const char* kind, const std::vector<double>& numbers);
  void AddShape(const Line& line, const char* kind, const std::vector<double>& numbers, int material);
  /// A mesh of a file in a right-handed world, which is ours already: scaled, then moved by `offset`.
  void AddModel(Line& line, const Token& file, const R3::Point& offset, double scale, int material);
  /// With the place of a token.
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
  std::map<std::string_view, std::size_t> lines_of_materials_;      // all of the file's
  std::map<std::string_view, int> materials_;                       // those so far: index into Scene::materials
  std::map<Space, std::map<std::string_view, std::size_t>> taken_;  // name -> line
};

}  // namespace ray::comp30019
