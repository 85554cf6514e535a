#pragma once

#include <span>
#include <string>

#include "source/app/options/Options.h"

/// The names of files on the command line: scenes and pictures.
namespace ray {

/// " (usage: raypro scene image [options])"
std::string UsageOf(Program program, const CommandKind* command = nullptr);

/// Throws the UsageError of a word that is one too many; `why` ends it.
[[noreturn]] void RefuseName(const std::string& word, const std::string& why);

/// Decides which of the names that were typed is what: scenes with -out_folder, otherwise a scene and its picture.
/// Throws UsageError for a third, when one is missing, with a command that was probably meant, or when names contradict
/// each other.
///   words   as typed
void ShareNames(Options& options, std::span<const std::string> words);

/// "images/room.png": where -out_folder has the picture of a scene.
std::string PictureInFolder(const std::string& folder, const std::string& scene, const std::string& extension);

}  // namespace ray
