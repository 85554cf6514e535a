#pragma once

#include <string>

namespace ray {

/// The script that teaches a shell ("bash", "zsh" or "fish") our options.
std::string CompletionScript(const std::string& shell);

}  // namespace ray
