#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// The script that teaches bash the program's options.
std::string BashCompletion(const Program& program);

}  // namespace ray
