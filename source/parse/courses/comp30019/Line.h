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

/// Returns the tokens of every nonempty line. Lines are split at white space, and at " ( ) and commas, which are also
/// tokens. A byte order mark at the start is skipped.
std::vector<std::vector<Token>> TokensByLine(const Text& text);

/// One line of a scene while it is read: a command and its arguments. A wrong value is recorded and reading continues,
/// so that one run reports all mistakes in a line; wrong punctuation and a missing value end it. A line with errors
/// must have no effect.
class Line {
 public:
  /// Thrown if the line cannot be read further; the error has been recorded.
  struct Incomplete {};

  /// Prepares to read a line, which must outlive this; `usage` is shown if something is missing.
  Line(const Text& text, std::span<const Token> tokens, std::string usage)
      : text_(text), tokens_(tokens), usage_(std::move(usage)) {}

  /// Reads a token in quotes.
  Token Name(const char* what);
  /// Reads a token that is neither name nor number.
  Token Word(const char* what);
  Number Real(const char* what);
  /// Reads (x, y, z); `parts` contains their names, one letter each.
  Triple Vector(const char* what, std::string_view parts);
  /// Returns the tokens that remain after the command; they are ignored.
  std::span<const Token> Rest() const { return tokens_.subspan(next_); }

  void Error(const Token& at, std::string message, std::string hint = {});
  const Token& Command() const { return tokens_[0]; }
  bool IsGood() const { return errors_.empty(); }
  std::vector<SceneError> Errors() && { return std::move(errors_); }

 private:
  /// Reports an error and ends the line.
  [[noreturn]] void Stop(const Token& at, std::string message);
  /// Returns the next token, which must exist; `what` names it in messages.
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
