#include "source/view/HelpText.h"

#include <algorithm>
#include <sstream>

namespace ray {
namespace {

constexpr std::size_t text_column = 26;  // the longest gesture, and a blank

bool BeginsLetter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

/// The bytes of `count` letters from `at` on, or of those that are left.
std::string Letters(const std::string& text, std::size_t at, std::size_t count) {
  std::size_t end = at;
  for (; end < text.size(); ++end)
    if (BeginsLetter(text[end]) && count-- == 0) break;
  return text.substr(at, end - at);
}

}  // namespace

std::size_t CountLetters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, BeginsLetter));
}

std::vector<std::string> InLines(const std::string& text, int columns) {
  const auto width = static_cast<std::size_t>(std::max(columns, 1));
  if (CountLetters(text) <= width) return {text};
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.empty() && CountLetters(lines.back()) + 1 + CountLetters(word) <= width) {
      lines.back() += " " + word;
      continue;
    }
    for (std::size_t at = 0; at < word.size(); at += lines.back().size()) lines.push_back(Letters(word, at, width));
  }
  return lines;
}

std::vector<std::string> HelpLines(const std::vector<HelpRow>& rows) {
  std::vector<std::string> lines;
  for (const HelpRow& row : rows) {
    const std::size_t blanks = row.keys.empty() ? 0 : text_column - std::min(text_column - 1, row.keys.size());
    lines.push_back(row.keys + std::string(blanks, ' ') + row.text);
  }
  return lines;
}

}  // namespace ray
