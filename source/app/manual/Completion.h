#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// The script that teaches a shell ("bash", "zsh" or "fish") the program's options.
std::string CompletionScript(const Program& program, const std::string& shell);

}  // namespace ray
