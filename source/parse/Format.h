#pragma once

#include <span>
#include <vector>

#include "source/parse/Files.h"
#include "source/parse/Parse.h"
#include "source/parse/SceneError.h"

namespace ray {

class Assets;
class Document;

/// One line of formats.def: a language for scenes. It has one of two reader functions.
struct SceneFormat {
  const char* name;
  std::vector<const char*> extensions;  // lower case, with the dot
  const char* about;                    // one line of help
  /// Reads the scene at the top of `files`; mistakes and remarks go to `report`. After a mistake the returned scene is
  /// meaningless.
  Scene (*read)(const Files& files, const ParseOptions& options, Assets& assets, Report& report) = nullptr;
  /// Reads a scene in a language based on YAML or JSON.
  Scene (*read_document)(const ParseOptions& options, const Document& document, Assets& assets,
                         Report& report) = nullptr;
  /// The top-level keys that distinguish this language from others with the same extension.
  std::vector<const char*> keys{};
  bool has_variables = false;  // ParseOptions::definitions apply to it
};

/// Returns all formats, in the order of formats.def.
std::span<const SceneFormat* const> SceneFormats();

/// Returns true if a file's extension, in any letter case, is that of a scene.
bool IsSceneName(const std::string& file);

}  // namespace ray
