#pragma once

#include "source/parse/Files.h"
#include "source/parse/Parse.h"
#include "source/parse/Report.h"

namespace ray {

/// One line of formats.def: a language scenes are written in.
struct SceneFormat {
  const char* extension;  // lower case, with the dot
  /// Reads the scene that is at the top of `files`; mistakes and remarks go to `report`, and with one mistake there the
  /// scene is worth nothing.
  Scene (*read)(const Files& files, const ParseOptions& options, Report& report);
};

#define SCENE_FORMAT(name) extern const SceneFormat name##_scene_format;
#include "source/parse/formats.def"
#undef SCENE_FORMAT

}  // namespace ray
