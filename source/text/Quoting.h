#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ray {

inline constexpr std::size_t most_quoted = 60;  // the maximum length of a word that a message quotes, in bytes

/// Returns the number of characters in a line of UTF-8: the bytes that are not continuation bytes.
std::size_t CountCharacters(std::string_view bytes);

/// The first character of a UTF-8 text: its bytes and its code point, or one byte and 0 if it is not UTF-8.
struct CodedCharacter {
  std::size_t bytes = 1;
  char32_t code = 0;
};
CodedCharacter FirstCharacter(std::string_view text);

/// Makes untrusted bytes safe for a terminal: control characters and invalid UTF-8 become \xNN.
std::string Escaped(std::string_view bytes);
/// Escapes bytes, puts them in quotes and shortens them if long: 'spere'.
std::string Quoted(std::string_view bytes);
/// Escapes and quotes the path of an existing file, which limits its length. Not shortened, since the end of a path is
/// most informative.
std::string QuotedPath(std::string_view bytes);
/// Returns a line for display above a caret, with the same number of characters: those that Escaped() would change
/// become '?'.
std::string ShownLine(std::string_view line);

/// Returns a field of a CSV table, quoted if necessary. source: RFC 4180
std::string CsvField(const std::string& text);

/// "file:line:column", escaped; the file alone when line is 0.
std::string Place(const std::string& file, std::size_t line, std::size_t column);

}  // namespace ray
