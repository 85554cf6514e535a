#pragma once

#include <string>

namespace ray::rayimg {

/// What -help prints: of everything, of one command, or ("markdown") the README's table.
std::string Help(const std::string& subject);

std::string Version();

/// The script that teaches a shell ("bash", "zsh" or "fish") our commands and options.
std::string CompletionScript(const std::string& shell);

/// The manual page rayimg.1, in the language of the man macros.
std::string ManualPage();

}  // namespace ray::rayimg
