#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// The script that teaches a shell ("bash", "zsh" or "fish") the program's options.
std::string CompletionScript(Program program, const std::string& shell);

/// The words with blanks between them.
std::string Joined(const std::vector<std::string>& words);
/// Text within single quotes of any of the three shells; `marks`, those that zsh knows within a specification, are
/// escaped as well.
std::string Quotable(const std::string& text, const std::string& marks);

}  // namespace ray
