#pragma once

#include <span>
#include <string>

#include "source/app/options/Options.h"

namespace ray {

/// What the words behind a program's name ask for. Names and options in any order; -width 512, --width 512 and
/// -width=512 are the same; of an option given twice the last counts; behind "--" everything is a name. Throws
/// UsageError.
Options ReadCommandLine(Program program, std::span<const std::string> words);

/// Works out what follows from the options of a scene's picture once its own settings are among them, and throws
/// UsageError for what contradicts them.
void CompleteForScene(Options& options);

/// Throws UsageError when this machine lacks the denoiser or the instruction set that is asked for.
void CheckMachine(const RenderSettings& render, const AcceleratorSettings& accelerator);

}  // namespace ray
