#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ray {

inline constexpr std::size_t most_quoted = 60;  // bytes of a word that a message repeats

/// How many characters a line of UTF-8 has: every byte that does not continue a character begins one.
std::size_t CountCharacters(std::string_view bytes);

/// The first character of a text of UTF-8: its bytes and its code point, or one byte and 0 where that is no UTF-8.
struct CodedCharacter {
  std::size_t bytes = 1;
  char32_t code = 0;
};
CodedCharacter FirstCharacter(std::string_view text);

/// Bytes from a stranger made fit for a terminal: control characters and what is not UTF-8 as \xNN.
std::string Escaped(std::string_view bytes);
/// Escapes bytes, puts them in quotes and shortens them if long: 'spere'.
std::string Quoted(std::string_view bytes);
/// Escapes the path of a file that exists, and so is not endless, and puts it in quotes: whole, since its end says
/// most.
std::string QuotedPath(std::string_view bytes);
/// A line to be shown above a caret: as many characters as before, those that Escaped() would change as '?'.
std::string ShownLine(std::string_view line);

/// A field of a table in CSV, in quotes where it needs them. source: RFC 4180
std::string CsvField(const std::string& text);

/// "file:line:column", escaped; the file alone when line is 0.
std::string Place(const std::string& file, std::size_t line, std::size_t column);

}  // namespace ray
