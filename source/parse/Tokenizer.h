#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "source/parse/Text.h"
#include "source/parse/Variables.h"

namespace ray {

/// A reader that splits a text into words, separated by any white space; a line ends with LF, CR LF or CR. A byte order
/// mark at the start is skipped.
class Tokenizer {
 public:
  /// The treatment of #. With hash, it starts a comment if it begins a word or directly follows a number
  /// ("1.9#object"), as in the course's reader. In any other word, which may name a file, it is a letter, as in
  /// "1.#QNAN".
  enum class Comments { none, hash };

  /// The treatment of a backslash at the end of a line. With backslash, it joins the next line, whose words do not
  /// start a line.
  enum class Joints { none, backslash };

  /// The treatment of quotes. With names, a word that begins with a quote extends to the next quote on its line,
  /// including blanks; \" is a literal quote. The word's text includes its quotes. A formula in parentheses, which ends
  /// on its line, is also one word.
  enum class Quotes { none, names };

  /// Prepares the words of `text`, which must outlive the tokenizer and its tokens. So must `variables`, whose values
  /// replace words that begin with a dollar sign, and formulas; null for texts without variables.
  Tokenizer(const Text& text, Comments comments, Joints joints = Joints::none, Quotes quotes = Quotes::none,
            Variables* variables = nullptr);

  /// Returns the next word; std::nullopt at the end of the text.
  std::optional<Token> Next();
  const std::optional<Token>& Peek();
  /// Skips the rest of a line, and returns the number of words skipped.
  std::size_t SkipLine(std::size_t line);

  /// Returns the bytes after the last word that Next or Peek returned: an upper limit for a header's sizes.
  std::size_t BytesLeft() const { return static_cast<std::size_t>(end_ - next_); }
  const Text& Source() const { return text_; }

  /// Returns the errors of formulas that have no value. Each such formula is read as 1, so that parsing can continue.
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
