#pragma once

#include <string>
#include <string_view>

namespace ray {

// Names of files in a .scn file. A name that holds blanks, a # or a line end stands in quotes, as in "my wood.png";
// within them \" is a quote, \\ a backslash, \n and \r are the line ends of that name in C.

inline constexpr const char* quoting_rules = "a quoted name ends on its line; \\\" is a quote in it, \\\\ a backslash";

/// A name as a word says it; `problem` is null or what is wrong with the word.
struct NameOfWord {
  std::string name;
  const char* problem = nullptr;
};

/// The name that a word of a .scn file means: the word itself unless it begins with a quote.
NameOfWord Unquoted(std::string_view word);
/// The word that means a name: the name itself where a reader would take it whole, otherwise in quotes.
std::string QuotedWhereNeeded(const std::string& name);

}  // namespace ray
