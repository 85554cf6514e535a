#pragma once

#include <string>
#include <string_view>

namespace ray {

// Names of files in a .scn file. A name that contains blanks, a # or a line end is quoted, as in "my wood.png"; inside
// the quotes \" is a quote, \\ a backslash, and \n and \r are line ends as in C.

inline constexpr const char* quoting_rules = "a quoted name ends on its line; \\\" is a quote in it, \\\\ a backslash";

/// A name given by a word; `problem` is null or the fault of the word.
struct NameOfWord {
  std::string name;
  const char* problem = nullptr;
};

/// Returns the name given by a word of a .scn file: the word itself unless it begins with a quote.
NameOfWord Unquoted(std::string_view word);
/// Returns the word for a name: the name itself if a reader would read it completely, otherwise quoted.
std::string QuotedWhereNeeded(const std::string& name);

}  // namespace ray
