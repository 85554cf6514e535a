#include "source/parse/Text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "source/text/LookAlike.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr std::size_t max_line_shown = 200;  // bytes of a line; a mistake further right is shown without its line

// Searches only as far as would be shown, since the line may be the whole of a large file.
std::string LineAround(const Text& text, const Token& token) {
  const char* const begin = text.bytes.data();
  const char* const end = begin + text.bytes.size();
  const char* const word = token.InFile().data();
  const char* first = word;
  while (first != begin && !EndsLine(first[-1]) && word - first < std::ptrdiff_t{max_line_shown}) --first;
  if (first != begin && !EndsLine(first[-1])) return {};
  const char* const furthest = first + std::min<std::ptrdiff_t>(end - first, max_line_shown);
  std::string line(first, std::find_if(first, furthest, EndsLine));
  if (line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
  return line;
}

/// Returns the word, or its first character if the word is shorter than that, as JSON parsers report it.
std::string_view WithWholeCharacter(const Text& text, std::string_view word) {
  const char* const end = text.bytes.data() + text.bytes.size();
  if (word.empty() || word.data() < text.bytes.data() || word.data() >= end) return word;
  const std::string_view rest(word.data(), static_cast<std::size_t>(end - word.data()));
  return rest.substr(0, std::max(word.size(), FirstCharacter(rest).bytes));
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
  error.hint = LookAlikeHint(WithWholeCharacter(text, token.InFile()));
  if (error.hint.empty()) error.hint = std::move(hint);
  return error;
}

std::string HexColorHint(const Text& text, const Token& token) {
  const char* const behind = token.InFile().data() + token.InFile().size();
  const char* const end = text.bytes.data() + text.bytes.size();
  if (behind < text.bytes.data() || behind > end) return {};
  std::string_view rest(behind, static_cast<std::size_t>(end - behind));
  rest = rest.substr(0, rest.find_first_of("\r\n"));
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t:"), rest.size()));
  if (!rest.starts_with('#')) return {};
  const std::string_view digits = rest.substr(1, std::min(rest.find_first_of(" \t,;"), rest.size()) - 1);
  const bool is_color = (digits.size() == 3 || digits.size() == 6 || digits.size() == 8) &&
                        digits.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  if (!is_color) return {};
  const std::size_t of_channel = digits.size() == 3 ? 1 : 2;
  std::string channels;
  for (std::size_t i = 0; i < 3; ++i) {
    int value = 0;
    std::from_chars(digits.data() + i * of_channel, digits.data() + (i + 1) * of_channel, value, 16);
    const double share = value / (of_channel == 1 ? 15.0 : 255.0);
    channels += " " + ToText(std::round(share * 1000) / 1000);
  }
  return "a # begins a comment; a color is three numbers from 0 to 1:" + channels;
}

SceneError ErrorIn(const std::string& file, std::string message, std::string hint) {
  SceneError error;
  error.file = file;
  error.message = std::move(message);
  error.hint = std::move(hint);
  return error;
}

std::optional<SceneError> FindNul(const Text& text) {
  const std::size_t nul = text.bytes.find('\0');
  if (nul == std::string::npos) return {};
  return ErrorAt(text, TextPlaces(text).At({nul, 1}), "NUL byte: this is not a text file", "save UTF-16 as UTF-8");
}

TextPlaces::TextPlaces(const Text& text) : text_(text) {
  Place place;
  for (std::size_t i = 0; i < text.bytes.size(); ++i) {
    if (i % stride == 0) noted_.push_back(place);
    Step(place, i);
  }
  if (text.bytes.size() % stride == 0) noted_.push_back(place);
}

// A line ends with LF, CR LF or CR. A byte order mark and continuation bytes take no column.
void TextPlaces::Step(Place& place, std::size_t offset) const {
  const std::string& bytes = text_.bytes;
  const char c = bytes[offset];
  const bool is_cr_of_crlf = c == '\r' && offset + 1 < bytes.size() && bytes[offset + 1] == '\n';
  if (EndsLine(c) && !is_cr_of_crlf) {
    ++place.line;
    place.column = 1;
  } else if (!is_cr_of_crlf && !(offset == 0 && bytes.starts_with(byte_order_mark))) {
    place.column += CountCharacters({&bytes[offset], 1});
  }
}

Token TextPlaces::At(const Extent& extent) const {
  const std::size_t offset = std::min(extent.offset, text_.bytes.size());
  Place place = noted_[offset / stride];
  for (std::size_t i = offset - offset % stride; i < offset; ++i) Step(place, i);
  return {std::string_view(text_.bytes).substr(offset, extent.length), place.line, place.column, false};
}

}  // namespace ray
