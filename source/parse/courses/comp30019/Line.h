#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "source/parse/Text.h"

namespace ray::comp30019 {

/// A number and the token it was read from, for messages.
struct Number {
  double value = 0;
  Token token;
};
using Triple = std::array<Number, 3>;

/// The tokens of every line that has any: a line is cut at white space, and at " ( ) and commas, which are tokens
/// themselves. A byte order mark at the start is passed over.
std::vector<std::vector<Token>> TokensByLine(const Text& text);

/// One line of a scene, a command and what it takes, while it is read. A wrong value is noted and reading goes on, so
/// that one run tells all that is wrong with a line; wrong punctuation and a missing value end it. A line with errors
/// must have no effect.
class Line {
 public:
  /// Thrown when the line cannot be read on; the error has been noted.
  struct Incomplete {};

  /// The line must outlive this; `usage` is shown where something is missing.
  Line(const Text& text, std::span<const Token> tokens, std::string usage)
      : text_(text), tokens_(tokens), usage_(std::move(usage)) {}

  /// A token in quotes.
  Token Name(const char* what);
  /// A token that is neither name nor number.
  Token Word(const char* what);
  Number Real(const char* what);
  /// (x, y, z); `parts` names them, a letter each.
  Triple Vector(const char* what, std::string_view parts);
  /// What is left over behind the command; nothing of it is used.
  std::span<const Token> Rest() const { return tokens_.subspan(next_); }

  void Error(const Token& at, std::string message, std::string hint = {});
  const Token& Command() const { return tokens_[0]; }
  bool IsGood() const { return errors_.empty(); }
  std::vector<SceneError> Errors() && { return std::move(errors_); }

 private:
  /// An error that ends the line.
  [[noreturn]] void Stop(const Token& at, std::string message);
  /// The next token, which must be there: `what` is to begin with it.
  Token Next(const std::string& what);
  void Expect(std::string_view mark, const std::string& where, const std::string& what);
  Number RealNamed(const std::string& what);

  const Text& text_;
  std::span<const Token> tokens_;
  std::string usage_;
  std::size_t next_ = 1;
  std::vector<SceneError> errors_;
};

}  // namespace ray::comp30019
