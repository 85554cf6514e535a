#pragma once

#include <span>
#include <vector>

#include "source/parse/Files.h"
#include "source/parse/Parse.h"
#include "source/parse/SceneError.h"

namespace ray {

class Assets;
class Document;

/// One line of formats.def: a language scenes are written in. Its reader is one of two.
struct SceneFormat {
  const char* name;
  std::vector<const char*> extensions;  // lower case, with the dot
  const char* about;                    // one line
  /// Reads the scene that is at the top of `files`; mistakes and remarks go to `report`, and with one mistake there the
  /// scene is worth nothing.
  Scene (*read)(const Files& files, const ParseOptions& options, Assets& assets, Report& report) = nullptr;
  /// Reads a scene in a language within YAML or JSON.
  Scene (*read_document)(const ParseOptions& options, const Document& document, Assets& assets,
                         Report& report) = nullptr;
  /// Keys at the top of a document by which this language is known among those that share its extension.
  std::vector<const char*> keys{};
  bool has_variables = false;  // ParseOptions::definitions are for it
};

/// Every one, in the order of formats.def.
std::span<const SceneFormat* const> SceneFormats();

/// Returns true if a file's extension, in any letter case, is that of a scene.
bool IsSceneName(const std::string& file);

}  // namespace ray
