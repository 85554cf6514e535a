#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "source/parse/SceneError.h"

namespace ray {

/// A file in memory, under the name that messages give it.
struct Text {
  std::string name;
  std::string bytes;
};

/// A word of a text and where it stands. `text` looks into the Text's bytes.
struct Token {
  std::string_view text;
  std::size_t line = 0, column = 0;  // from 1, column in characters
  bool starts_line = false;
};

/// A mistake at a word.
SceneError ErrorAt(const Text& text, const Token& token, std::string message, std::string hint = {});
/// A mistake of the file as a whole.
SceneError ErrorIn(const std::string& file, std::string message, std::string hint = {});

/// How many characters a line of UTF-8 has: every byte that does not continue a character begins one.
std::size_t CountCharacters(std::string_view bytes);

/// Bytes from a stranger made fit for a terminal: control characters and what is not UTF-8 as \xNN.
std::string Escaped(std::string_view bytes);
/// The same in quotes, and shortened if long: 'spere'.
std::string Quoted(std::string_view bytes);
/// The same for the path of a file that is there, and so not endless: whole, since its end says most.
std::string QuotedPath(std::string_view bytes);
/// A line to be shown above a caret: as many characters as before, those that Escaped() would change as '?'.
std::string ShownLine(std::string_view line);

/// "file:line:column", escaped; the file alone when line is 0.
std::string Place(const std::string& file, std::size_t line, std::size_t column);

}  // namespace ray
