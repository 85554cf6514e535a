#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace ray {

/// Lowers ASCII letters only: what a name means does not depend on the locale.
inline char LowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
inline std::string LowerCase(std::string text) {
  for (char& c : text) c = LowerCase(c);
  return text;
}

/// Whether a word is, or begins with, this one in lower case, its own letter case apart.
inline bool IsInAnyCase(std::string_view word, std::string_view lower) {
  return std::ranges::equal(word, lower, [](char a, char b) { return LowerCase(a) == b; });
}
inline bool BeginsInAnyCase(std::string_view word, std::string_view lower) {
  return IsInAnyCase(word.substr(0, lower.size()), lower);
}

}  // namespace ray
