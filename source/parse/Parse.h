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

/// Texts that are read in place of files on the disk, by the canonical path of the file: absolute and without links.
using EditedFiles = std::map<std::string, std::string>;

/// Why a scene cannot make a setting.
struct SettingProblem {
  std::string message, hint;  // the hint may be empty
};

/// What takes the place of a scene's own camera, part by part.
struct CameraChange {
  std::optional<R3::Point> eye, target;  // without a target the viewing direction stays
  std::optional<R3::Vector> up;
  std::optional<double> fov;  // whole horizontal field of view, degrees, in (0, 360]
  std::string projection;     // a name of cameras.def; empty for the scene's own

  friend bool operator==(const CameraChange&, const CameraChange&) = default;
};

/// How a scene is read.
struct ParseOptions {
  // Where files named by a scene may lie, beside its own folder and the current one.
  std::vector<std::string> allowed_folders;
  std::string format;                    // a name of formats.def; empty: by extension, and keys of JSON
  bool decode_srgb = false;              // 8-bit textures are sRGB and become linear
  double aspect = 1;                     // of the picture, for scenes that name no camera and are shown whole
  bool one_sided = false;                // every material is, but of what is clear or absorbs
  std::vector<std::string> definitions;  // of variables, "name=value"
  std::string environment;               // file that takes the place of the scene's own; empty for none
  CameraChange camera;
  int include_depth = 64;                        // how deep includes may nest
  std::size_t max_nodes = std::size_t{1} << 24;  // about 5 GB of them; includes that double would never end
  std::int64_t max_texture_bytes = std::numeric_limits<std::int64_t>::max();  // of all of them, decoded
  // What is wrong with a setting, if anything: which options there are the program knows, and no reader. Without it
  // settings are taken as they stand.
  std::optional<SettingProblem> (*problem_of)(const SceneSetting&) = nullptr;
  std::shared_ptr<const EditedFiles> edited{};  // null where the files of the disk are read; for .scn files only
  ScnPlaces* places = nullptr;                  // filled in with where the statements of a .scn scene stand, if not null

  friend bool operator==(const ParseOptions&, const ParseOptions&) = default;
};

/// A scene and what its author should know about it.
struct ParsedScene {
  Scene scene;
  std::vector<std::string> warnings;  // "file:line:column: warning: ..." whole lines
};

/// Reads a scene file; its format is decided by extension (formats.def), and among formats of one extension by the keys
/// at its top. A file of a mesh is a scene of that mesh alone. Defaults for camera and lights are filled in. Throws
/// SceneErrors, whose what() is the whole report.
ParsedScene Parse(const std::string& file, const ParseOptions& options);

}  // namespace ray
