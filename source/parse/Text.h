#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/parse/SceneError.h"
#include "source/scene/Location.h"
#include "source/text/Quoting.h"

namespace ray {

/// A file in memory, with its name in messages.
struct Text {
  std::string name;
  std::string bytes;
};

/// A word of a text and its position. `text` refers to the Text's bytes.
struct Token {
  std::string_view text;
  std::size_t line = 0, column = 0;  // 1-based, column in characters
  bool starts_line = false;
  std::string_view variable{};  // the original text if `text` is the value of a variable or formula
  bool is_broken = false;       // a formula without a value, which has been reported

  std::string_view InFile() const { return variable.empty() ? text : variable; }
};

inline bool IsSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
inline bool EndsLine(char c) { return c == '\n' || c == '\r'; }

/// Returns the position of a word in the file with that index in Scene::files; lines and columns are clamped to 2^32 -
/// 1.
Location LocationOf(std::uint32_t file, const Token& token);
/// Returns an error at a word. If the word has a look-alike character, that is the hint.
SceneError ErrorAt(const Text& text, const Token& token, std::string message, std::string hint = {});
/// Returns a hint if a word is followed by a color such as #ff0000, which is a comment; otherwise an empty text.
std::string HexColorHint(const Text& text, const Token& token);
/// Returns an error about the file as a whole.
SceneError ErrorIn(const std::string& file, std::string message, std::string hint = {});
/// Returns an error at the first NUL byte, which text must not contain, if there is one.
std::optional<SceneError> FindNul(const Text& text);

inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// A range of bytes of the document's text.
struct Extent {
  std::size_t offset = 0, length = 1;
};

/// A map from offsets to lines and columns of a text. Some are precomputed, so that a query walks over at most a few
/// thousand bytes, even in a file of a single line.
class TextPlaces {
 public:
  /// Prepares the map; `text` must outlive this and the tokens.
  explicit TextPlaces(const Text& text);

  Token At(const Extent& extent) const;

 private:
  struct Place {
    std::size_t line = 1, column = 1;
  };
  static constexpr std::size_t stride = 4096;  // bytes between precomputed positions

  void Step(Place& place, std::size_t offset) const;

  const Text& text_;
  std::vector<Place> noted_;
};

}  // namespace ray
