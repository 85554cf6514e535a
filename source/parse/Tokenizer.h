#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "source/parse/Text.h"
#include "source/parse/Variables.h"

namespace ray {

/// Cuts a text into words, separated by any white space; a line ends with LF, CR LF or CR. A byte order mark at the
/// start is passed over.
class Tokenizer {
 public:
  /// Whether a # hides the rest of its line: one that begins a word, or is glued to a number ("1.9#object"), as the
  /// course's reader has it. In any other word, which may name a file, it is a letter, and so it is in "1.#QNAN".
  enum class Comments { none, hash };

  /// Whether a backslash at the end of a line joins the next one to it: words there do not start a line.
  enum class Joints { none, backslash };

  /// Whether a word that begins with a quote goes on to the next one on its line, blanks and all; behind a backslash a
  /// quote is a letter of it. The word's text has its quotes. A formula in parentheses, which ends on its line, is one
  /// word as well.
  enum class Quotes { none, names };

  /// `text` must outlive the tokenizer and its tokens, and so must `variables`, whose values take the place of words
  /// that begin with a dollar sign and of formulas; null for texts without variables.
  Tokenizer(const Text& text, Comments comments, Joints joints = Joints::none, Quotes quotes = Quotes::none,
            Variables* variables = nullptr);

  /// Nothing at the end of the text.
  std::optional<Token> Next();
  const std::optional<Token>& Peek();
  /// Passes over what is left of a line, and tells how many words that was.
  std::size_t SkipLine(std::size_t line);

  /// Bytes behind the last word that Next or Peek saw: no more than these can follow, whatever a header promises.
  std::size_t BytesLeft() const { return static_cast<std::size_t>(end_ - next_); }
  const Text& Source() const { return text_; }

  /// Errors of formulas that have no value. Each such formula is read as 1, so that parsing can continue.
  const std::vector<SceneError>& Mistakes() const { return mistakes_; }
  std::vector<SceneError> TakeMistakes() { return std::exchange(mistakes_, {}); }

 private:
  std::optional<Token> Scan();
  std::size_t LengthOfWord() const;
  std::size_t LengthOfQuoted() const;
  std::size_t LengthOfFormula() const;
  void Evaluate(Token& token);
  void SkipWhiteSpace();
  bool IsJoint(const char* backslash) const;
  void SkipToLineEnd();

  const Text& text_;
  Comments comments_;
  Joints joints_;
  Quotes quotes_;
  Variables* variables_;
  const char* next_;
  const char* end_;
  std::size_t line_ = 1, column_ = 1;
  bool at_line_start_ = true;
  bool has_peeked_ = false;
  std::optional<Token> peeked_;
  std::vector<SceneError> mistakes_;
};

}  // namespace ray
