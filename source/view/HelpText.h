#pragma once

#include <string>
#include <vector>

namespace ray {

/// A line of help; one without keys is a heading.
struct HelpRow {
  std::string keys, text;
};

/// The words in lines of at most `columns` letters; longer words are broken.
std::vector<std::string> InLines(const std::string& text, int columns);

/// In two columns, lines at most `columns` wide as far as words allow; no limit below 1.
std::vector<std::string> HelpLines(const std::vector<HelpRow>& rows, int columns);

/// The same on pages of at most `lines` lines, at least 2: groups are kept together where they fit, and the last line
/// of each page says which one it is.
std::vector<std::vector<std::string>> HelpPages(const std::vector<HelpRow>& rows, int columns, int lines);

}  // namespace ray
