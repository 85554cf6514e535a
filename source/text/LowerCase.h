#pragma once

#include <string>

namespace ray {

/// Of ASCII letters only: what a name means does not depend on the locale.
inline std::string LowerCase(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace ray
