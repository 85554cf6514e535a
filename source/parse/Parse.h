#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "source/parse/SceneError.h"
#include "source/scene/Scene.h"

namespace ray {

struct ScnPlaces;

/// Texts that replace files on disk, keyed by the canonical path of the file: absolute and without links.
using EditedFiles = std::map<std::string, std::string>;

/// A problem with a setting in a scene.
struct SettingProblem {
  std::string message, hint;  // the hint may be empty
};

/// Replacements for parts of a scene's own camera.
struct CameraChange {
  std::optional<R3::Point> eye, target;  // without a target the viewing direction is unchanged
  std::optional<R3::Vector> up;
  std::optional<double> fov;  // the whole horizontal field of view, degrees, in (0, 360]
  std::string projection;     // a name of cameras.def; empty for the scene's own

  friend bool operator==(const CameraChange&, const CameraChange&) = default;
};

/// The options for reading a scene.
struct ParseOptions {
  // Allowed locations of files named by a scene, in addition to its own folder and the current one.
  std::vector<std::string> allowed_folders;
  std::string format;                    // a name of formats.def; empty: by extension, and by keys for JSON
  bool decode_srgb = false;              // 8-bit textures are sRGB and are linearized
  double aspect = 1;                     // of the image, for scenes that name no camera and are fitted to the view
  bool one_sided = false;                // applies to every material, except clear or absorbing ones
  std::vector<std::string> definitions;  // of variables, "name=value"
  std::string environment;               // file that replaces the scene's own; empty for none
  CameraChange camera;
  int include_depth = 64;                                                     // maximum depth of nested includes
  std::size_t max_nodes = std::size_t{1} << 24;                               // about 5 GB; limits includes that double
  std::int64_t max_texture_bytes = std::numeric_limits<std::int64_t>::max();  // decoded size of all textures
  // Returns the problem with a setting, if there is one. The program knows the options, readers do not. If null, all
  // settings are accepted.
  std::optional<SettingProblem> (*problem_of)(const SceneSetting&) = nullptr;
  std::shared_ptr<const EditedFiles> edited{};  // null to read the files on disk; for .scn files only
  ScnPlaces* places = nullptr;                  // if not null, receives the positions of the statements of a .scn scene

  friend bool operator==(const ParseOptions&, const ParseOptions&) = default;
};

/// A scene and the warnings for its author.
struct ParsedScene {
  Scene scene;
  std::vector<std::string> warnings;  // "file:line:column: warning: ..." whole lines
};

/// Reads a scene file. Its format is determined by the extension (formats.def), and among formats with one extension by
/// the top-level keys. A mesh file is a scene of that mesh alone. Missing cameras and lights are replaced by defaults.
/// Throws SceneErrors, whose what() is the whole report.
ParsedScene Parse(const std::string& file, const ParseOptions& options);

}  // namespace ray
