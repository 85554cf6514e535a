#include "source/parse/scn/QuotedName.h"

#include <algorithm>
#include <array>

#include "source/parse/Text.h"

namespace ray {
namespace {

struct Escape {
  char letter, meaning;
};

constexpr std::array escapes{
    Escape{'"', '"'},
    Escape{'\\', '\\'},
    Escape{'n', '\n'},
    Escape{'r', '\r'},
};

/// Returns true if the name needs quotes: the tokenizer ends words at white space, and may treat a # as the start of a
/// comment. A 0 means no texture.
bool NeedsQuotes(const std::string& name) {
  return name.empty() || name == "0" || name.starts_with('"') ||
         std::ranges::any_of(name, [](char c) { return IsSpace(c) || c == '#'; });
}

}  // namespace

NameOfWord Unquoted(std::string_view word) {
  if (!word.starts_with('"')) return {std::string(word)};
  NameOfWord read;
  for (std::size_t i = 1; i < word.size(); ++i) {
    if (word[i] == '"') return i == 1 ? NameOfWord{{}, "the name between the quotes is empty"} : read;
    if (word[i] != '\\') {
      read.name += word[i];
      continue;
    }
    const char letter = ++i < word.size() ? word[i] : '\0';
    const auto escape = std::ranges::find(escapes, letter, &Escape::letter);
    if (escape == escapes.end()) return {{}, "a backslash in quotes must be followed by \\, \", n or r"};
    read.name += escape->meaning;
  }
  return {{}, "the closing quote is missing"};
}

std::string QuotedWhereNeeded(const std::string& name) {
  if (!NeedsQuotes(name)) return name;
  std::string quoted = "\"";
  for (const char c : name) {
    const auto escape = std::ranges::find(escapes, c, &Escape::meaning);
    if (escape == escapes.end())
      quoted += c;
    else
      quoted += {'\\', escape->letter};
  }
  return quoted + "\"";
}

}  // namespace ray
