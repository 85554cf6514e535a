#pragma once

#include <span>
#include <string>

#include "source/app/options/RenderOptions.h"

/// Checks of options that are valid individually but wrong together.
namespace ray {

/// Applies the preset, assigns the names and derives dependent values. Throws UsageError for contradictions that do not
/// depend on the scene.
///   words   as typed
void CompleteCommandLine(RenderOptions& options, std::span<const std::string> words);

/// Derives dependent values from the options of a scene's image, including its own settings, and throws UsageError for
/// contradictions.
void CompleteForScene(RenderOptions& options);

/// Throws UsageError if this machine lacks the selected denoiser or instruction set.
void CheckMachine(const RenderSettings& render, const AcceleratorSettings& accelerator);

}  // namespace ray
