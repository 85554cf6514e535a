#pragma once

#include <string>

#include "source/app/Program.h"

namespace ray {

/// The manual page raypro.1 or rayview.1, in the language of the man macros.
std::string ManualPage(Program program);

/// Text as roff takes it literally: a backslash and a dash are escaped, a line never starts with a control character.
std::string Roff(const std::string& text);

}  // namespace ray
