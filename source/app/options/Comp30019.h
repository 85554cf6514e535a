#pragma once

#include <span>
#include <string>
#include <vector>

#include "source/app/options/RenderOptions.h"

/// The command line of COMP30019, Graphics and Interaction, as its graders type it.
namespace ray::comp30019 {

/// Returns true if the program was called by the name comp30019, or with -as comp30019 first.
bool IsAskedFor(int argc, const char* const* argv);

/// Returns the words after a program's name, preceded by -as comp30019: the equivalent arguments of raypro.
std::vector<std::string> WithRequest(std::span<const std::string> words);

/// Translates the words after a program's name, with or without -as comp30019: the course's 12 options and -one_sided
/// to raypro's, and the view. Throws UsageError.
RenderOptions ReadCommandLine(std::span<const std::string> words);

/// Returns the text that --help prints.
std::string Help();

}  // namespace ray::comp30019
