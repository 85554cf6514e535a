#include "source/parse/Text.h"

#include <algorithm>
#include <limits>

namespace ray {
namespace {

constexpr std::size_t max_line_shown = 200;  // bytes of a line; a mistake further right is shown without its line

// Looks no further than what would be shown: the line may be the whole of a large file.
std::string LineAround(const Text& text, const Token& token) {
  const char* const begin = text.bytes.data();
  const char* const end = begin + text.bytes.size();
  const char* const word = token.InFile().data();
  const char* first = word;
  while (first != begin && !EndsLine(first[-1]) && word - first < std::ptrdiff_t{max_line_shown}) --first;
  if (first != begin && !EndsLine(first[-1])) return {};
  const char* const furthest = first + std::min<std::ptrdiff_t>(end - first, max_line_shown);
  std::string line(first, std::find_if(first, furthest, EndsLine));
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  return line;
}

}  // namespace

Location LocationOf(std::uint32_t file, const Token& token) {
  const auto saturated = [](std::size_t n) {
    return static_cast<std::uint32_t>(std::min<std::size_t>(n, std::numeric_limits<std::uint32_t>::max()));
  };
  return {file, saturated(token.line), saturated(token.column)};
}

SceneError ErrorAt(const Text& text, const Token& token, std::string message, std::string hint) {
  SceneError error;
  error.file = text.name;
  error.line = token.line;
  error.column = token.column;
  error.message = std::move(message);
  error.source_line = LineAround(text, token);
  error.length = std::max<std::size_t>(1, CountCharacters(token.InFile().substr(0, most_quoted)));
  error.hint = std::move(hint);
  return error;
}

SceneError ErrorIn(const std::string& file, std::string message, std::string hint) {
  SceneError error;
  error.file = file;
  error.message = std::move(message);
  error.hint = std::move(hint);
  return error;
}

}  // namespace ray
