#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace ray {

/// Converts ASCII letters only: the meaning of a name does not depend on the locale.
inline char LowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
inline std::string LowerCase(std::string text) {
  for (char& c : text) c = LowerCase(c);
  return text;
}

/// Returns true if a word is, or begins with, `lower`, ignoring letter case.
inline bool IsInAnyCase(std::string_view word, std::string_view lower) {
  return std::ranges::equal(word, lower, [](char a, char b) { return LowerCase(a) == b; });
}
inline bool BeginsInAnyCase(std::string_view word, std::string_view lower) {
  return IsInAnyCase(word.substr(0, lower.size()), lower);
}

}  // namespace ray
