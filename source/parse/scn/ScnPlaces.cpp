#include "source/parse/scn/ScnPlaces.h"

#include <algorithm>
#include <string_view>

#include "source/parse/Tokenizer.h"

namespace ray {
namespace {

std::size_t BeginOfText(std::string_view bytes) {
  return bytes.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
}

/// Returns the offset after the end of the line that contains `at`; lines end with LF, CR LF or CR.
std::size_t NextLine(std::string_view bytes, std::size_t at) {
  while (at < bytes.size() && !EndsLine(bytes[at])) ++at;
  if (at + 1 < bytes.size() && bytes[at] == '\r' && bytes[at + 1] == '\n') ++at;
  return std::min(at + 1, bytes.size());
}

/// Returns the offset of the file's next statement, or its end. Statements of other files may come between.
std::size_t EndOf(const ScnPlaces& places, std::uint32_t statement) {
  const ScnPlaces::Statement& own = places.statements[statement];
  const auto behind = places.statements.begin() + static_cast<std::ptrdiff_t>(statement) + 1;
  const auto next = std::find_if(behind, places.statements.end(),
                                 [&](const ScnPlaces::Statement& other) { return other.file == own.file; });
  // If the file was read again from its start, this was its last statement.
  if (next != places.statements.end() && next->begin > own.begin) return next->begin;
  return places.files[own.file].text->bytes.size();
}

}  // namespace

std::vector<ScnWord> WordsOf(const ScnPlaces& places, std::uint32_t statement) {
  const ScnPlaces::Statement& own = places.statements[statement];
  const Text& whole = *places.files[own.file].text;
  const Text text{whole.name, whole.bytes.substr(own.begin, EndOf(places, statement) - own.begin)};
  std::vector<ScnWord> words;
  Tokenizer tokens(text, Tokenizer::Comments::hash, Tokenizer::Joints::none, Tokenizer::Quotes::names);
  while (const auto word = tokens.Next()) {
    const auto offset = static_cast<std::size_t>(word->text.data() - text.bytes.data());
    words.push_back({std::string(word->text), own.begin + offset});
  }
  return words;
}

std::optional<std::uint32_t> StatementAt(const ScnPlaces& places, std::uint32_t file, std::size_t begin) {
  const auto found = std::ranges::find_if(
      places.statements, [&](const ScnPlaces::Statement& s) { return s.file == file && s.begin == begin; });
  if (found == places.statements.end()) return {};
  return static_cast<std::uint32_t>(found - places.statements.begin());
}

std::optional<std::uint32_t> StatementAt(const ScnPlaces& places, const Location& location) {
  if (location.line == 0 || location.file >= places.files.size()) return {};
  const std::string& bytes = places.files[location.file].text->bytes;
  std::size_t at = BeginOfText(bytes);
  for (std::uint32_t line = 1; line < location.line; ++line) at = NextLine(bytes, at);
  for (std::uint32_t column = 1; column < location.column && at < bytes.size(); ++column) {
    ++at;
    while (at < bytes.size() && (static_cast<unsigned char>(bytes[at]) & 0xC0) == 0x80) ++at;  // in the same character
  }
  return StatementAt(places, location.file, at);
}

Location LocationAt(const ScnPlaces& places, std::uint32_t file, std::size_t offset) {
  return LocationOf(file, TextPlaces(*places.files[file].text).At({offset, 1}));
}

}  // namespace ray
