#pragma once

#include <span>
#include <string>

#include "source/app/options/RenderOptions.h"

/// What is wrong with options together, though each word is right by itself.
namespace ray {

/// Applies the preset, gives each name its role and works out what follows. Throws UsageError for what contradicts
/// each other whatever the scene is.
///   words   as typed
void CompleteCommandLine(RenderOptions& options, std::span<const std::string> words);

/// Works out what follows from the options of a scene's image once its own settings are among them, and throws
/// UsageError for what contradicts them.
void CompleteForScene(RenderOptions& options);

/// Throws UsageError when this machine lacks the denoiser or the instruction set that is asked for.
void CheckMachine(const RenderSettings& render, const AcceleratorSettings& accelerator);

}  // namespace ray
