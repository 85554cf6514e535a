#pragma once

#include <span>
#include <string>

#include "source/app/options/RenderOptions.h"

/// The names of files on the command line: scenes and images.
namespace ray {

/// Returns " (usage: raypro scene image [options])".
std::string UsageOf(const Program& program, const CommandKind* command = nullptr);

/// Throws a UsageError about an unexpected word; `why` ends its message.
[[noreturn]] void RefuseName(const std::string& word, const std::string& why);

/// Assigns the typed names: with -out_folder all are scenes, otherwise a scene and its image. Throws UsageError if
/// there is a third or one is missing, with the command that was probably meant, or if names contradict each other.
///   words   as typed
void ShareNames(RenderOptions& options, std::span<const std::string> words);

/// Returns "images/room.png": the file for a scene's image in the folder of -out_folder.
std::string ImageInFolder(const std::string& folder, const std::string& scene, const std::string& extension);

}  // namespace ray
