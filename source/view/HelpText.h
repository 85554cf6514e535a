#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ray {

/// A line of help; one without keys is a heading.
struct HelpRow {
  std::string keys, text;
};

/// Returns the number of letters of a text in UTF-8.
std::size_t CountLetters(std::string_view text);

/// Wraps a text in UTF-8 into lines of at most `columns` letters; longer words are broken.
std::vector<std::string> InLines(const std::string& text, int columns);

/// A line for each row, keys and texts below one another.
std::vector<std::string> HelpLines(const std::vector<HelpRow>& rows);

}  // namespace ray
