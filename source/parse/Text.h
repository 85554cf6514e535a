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
  std::string_view variable{};  // what stands in the file, where `text` is the value of a variable or formula
  bool is_broken = false;       // a formula without a value, which has been reported

  std::string_view InFile() const { return variable.empty() ? text : variable; }
};

inline bool IsSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
inline bool EndsLine(char c) { return c == '\n' || c == '\r'; }

/// Where a word stands, in the file of that index in Scene::files; lines and columns beyond 2^32 - 1 are that.
Location LocationOf(std::uint32_t file, const Token& token);
/// A mistake at a word. If the word has a character that only looks right, that is the hint.
SceneError ErrorAt(const Text& text, const Token& token, std::string message, std::string hint = {});
/// Returns a hint if a color such as #ff0000, which is a comment, stands behind a word; otherwise an empty text.
std::string HexColorHint(const Text& text, const Token& token);
/// A mistake of the file as a whole.
SceneError ErrorIn(const std::string& file, std::string message, std::string hint = {});
/// Returns an error where the first NUL byte stands, if there is one: in no text.
std::optional<SceneError> FindNul(const Text& text);

inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Where something is written: bytes of the document's text.
struct Extent {
  std::size_t offset = 0, length = 1;
};

/// Lines and columns of a text by offset. Some are noted ahead, so that asking costs a walk over a few thousand bytes
/// at most, even in a file of a single line.
class TextPlaces {
 public:
  /// `text` must outlive this and the tokens.
  explicit TextPlaces(const Text& text);

  Token At(const Extent& extent) const;

 private:
  struct Place {
    std::size_t line = 1, column = 1;
  };
  static constexpr std::size_t stride = 4096;  // bytes from one noted place to the next

  void Step(Place& place, std::size_t offset) const;

  const Text& text_;
  std::vector<Place> noted_;
};

}  // namespace ray
