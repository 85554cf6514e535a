#include "source/view/HelpText.h"

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace ray {
namespace {

constexpr std::size_t text_column = 26;  // the longest gesture, and a blank

/// Words in lines, the first of which has `first` characters before it, the others `indent` blanks.
std::vector<std::string> Wrapped(const std::string& before, const std::string& text, std::size_t indent,
                                 std::size_t width) {
  std::vector<std::string> lines{before};
  std::istringstream words(text);
  bool is_first = true;
  for (std::string word; words >> word; is_first = false) {
    if (!is_first && lines.back().size() + 1 + word.size() > width) {
      lines.emplace_back(indent, ' ');
      is_first = true;
    }
    lines.back() += (is_first ? "" : " ") + word;
  }
  return lines;
}

std::vector<std::string> LinesOf(const HelpRow& row, int columns) {
  if (row.keys.empty()) return {row.text};
  const std::size_t width = columns < 1 ? std::string::npos : static_cast<std::size_t>(columns);
  if (row.keys.size() < text_column)
    return Wrapped(row.keys + std::string(text_column - row.keys.size(), ' '), row.text, text_column, width);
  if (width == std::string::npos) return {row.keys + "  " + row.text};
  std::vector<std::string> lines = Wrapped("", row.keys, 0, width);
  for (std::string& line : Wrapped(std::string(text_column, ' '), row.text, text_column, width))
    lines.push_back(std::move(line));
  return lines;
}

}  // namespace

std::vector<std::string> InLines(const std::string& text, int columns) {
  const auto width = static_cast<std::size_t>(std::max(columns, 1));
  if (text.size() <= width) return {text};
  std::vector<std::string> lines;
  for (const std::string& line : Wrapped("", text, 0, width))
    for (std::size_t at = 0; at < line.size(); at += width) lines.push_back(line.substr(at, width));
  return lines;
}

std::vector<std::string> HelpLines(const std::vector<HelpRow>& rows, int columns) {
  std::vector<std::string> lines;
  for (const HelpRow& row : rows)
    for (std::string& line : LinesOf(row, columns)) lines.push_back(std::move(line));
  return lines;
}

std::vector<std::vector<std::string>> HelpPages(const std::vector<HelpRow>& rows, int columns, int lines) {
  const auto room = static_cast<std::size_t>(std::max(lines - 1, 1));
  std::vector<std::vector<std::string>> pages;
  for (auto row = rows.begin(); row != rows.end();) {
    const auto next = std::find_if(row + 1, rows.end(), [](const HelpRow& r) { return r.keys.empty(); });
    const std::vector<std::string> group = HelpLines({row, next}, columns);
    // A heading is not left alone at the end of a page.
    constexpr std::size_t least = 3;
    if (pages.empty() || pages.back().size() + std::min(group.size(), least) > room) pages.emplace_back();
    for (const std::string& line : group) {
      if (pages.back().size() == room) pages.emplace_back();
      pages.back().push_back(line);
    }
    row = next;
  }
  for (std::size_t i = 0; i < pages.size(); ++i)
    pages[i].push_back("page " + std::to_string(i + 1) + " of " + std::to_string(pages.size()) +
                       (i + 1 < pages.size() ? "; H: next page, Escape: close" : "; H or Escape: close"));
  return pages;
}

}  // namespace ray
