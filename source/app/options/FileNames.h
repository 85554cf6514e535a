#pragma once

#include <span>
#include <string>

#include "source/app/options/RenderOptions.h"

/// The names of files on the command line: scenes and images.
namespace ray {

/// " (usage: raypro scene image [options])"
std::string UsageOf(const Program& program, const CommandKind* command = nullptr);

/// Throws a UsageError about an unexpected word; `why` ends its message.
[[noreturn]] void RefuseName(const std::string& word, const std::string& why);

/// Decides what each of the names that were typed is: with -out_folder a scene, otherwise a scene and its image. Throws
/// UsageError if a third is given or one is missing, naming a command that was probably meant, or if names contradict
/// each other.
///   words   as typed
void ShareNames(RenderOptions& options, std::span<const std::string> words);

/// "images/room.png": the file in the folder of -out_folder that a scene's image goes to.
std::string PictureInFolder(const std::string& folder, const std::string& scene, const std::string& extension);

}  // namespace ray
