#pragma once

#include <span>
#include <string>
#include <vector>

#include "source/app/options/RenderOptions.h"

/// The command line of COMP30019, Graphics and Interaction, as its graders type it.
namespace ray::comp30019 {

/// Whether a program is to understand it: it was called by the name comp30019, or with -as comp30019 before all else.
bool IsAskedFor(int argc, const char* const* argv);

/// The words behind a program's name, with -as comp30019 before them: what to type to raypro.
std::vector<std::string> WithRequest(std::span<const std::string> words);

/// Translates the words behind a program's name, and perhaps -as comp30019: the course's 12 options and -one_sided into
/// raypro's, and the view. Throws UsageError.
RenderOptions ReadCommandLine(std::span<const std::string> words);

/// The text that --help prints.
std::string Help();

}  // namespace ray::comp30019
