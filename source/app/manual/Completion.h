#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// Returns the bash completion script for the program's options.
std::string BashCompletion(const Program& program);

}  // namespace ray
