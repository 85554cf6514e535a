#pragma once

#include <string>

namespace ray {

/// The manual page raypro.1, in the language of the man macros.
std::string ManualPage();

}  // namespace ray
