#pragma once

#include <span>
#include <string>

#include "source/app/options/Options.h"

namespace ray {

/// What the words behind a program's name ask for. Names and options in any order; -width 512, --width 512 and
/// -width=512 are the same; behind "--" everything is a name. Throws UsageError.
Options ReadCommandLine(Program program, std::span<const std::string> words);

/// Throws UsageError when this machine lacks what the options ask for.
void CheckMachine(const Options& options);

}  // namespace ray
