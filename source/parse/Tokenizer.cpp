#include "source/parse/Tokenizer.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "R3/Expression.h"
#include "source/text/Number.h"
#include "source/text/Quoting.h"

namespace ray {
namespace {

std::string_view WithoutComment(std::string_view word) {
  const std::size_t hash = word.find('#');
  if (hash == std::string_view::npos || ParseNumber(word.substr(0, hash)).problem || SaysNanOrInfinity(word))
    return word;
  return word.substr(0, hash);
}

}  // namespace

Tokenizer::Tokenizer(const Text& text, Comments comments, Joints joints, Quotes quotes, Variables* variables)
    : text_(text),
      comments_(comments),
      joints_(joints),
      quotes_(quotes),
      variables_(variables),
      next_(text.bytes.data()),
      end_(next_ + text.bytes.size()) {
  if (std::string_view(text.bytes).starts_with(byte_order_mark)) next_ += byte_order_mark.size();
}

std::optional<Token> Tokenizer::Next() {
  if (!has_peeked_) return Scan();
  has_peeked_ = false;
  return std::exchange(peeked_, std::nullopt);
}

const std::optional<Token>& Tokenizer::Peek() {
  if (!has_peeked_) peeked_ = Scan();
  has_peeked_ = true;
  return peeked_;
}

std::size_t Tokenizer::SkipLine(std::size_t line) {
  std::size_t words = 0;
  for (; Peek() && Peek()->line == line; ++words) Next();
  return words;
}

std::optional<Token> Tokenizer::Scan() {
  SkipWhiteSpace();
  while (comments_ == Comments::hash && next_ != end_ && *next_ == '#') {
    SkipToLineEnd();
    SkipWhiteSpace();
  }
  if (next_ == end_) return {};
  const char* const first = next_;
  Token token{{}, line_, column_, std::exchange(at_line_start_, false)};
  const bool is_quoted = quotes_ == Quotes::names && *first == '"';
  const std::size_t length_of_formula = quotes_ == Quotes::names && *first == '(' ? LengthOfFormula() : 0;
  token.text = {first, is_quoted ? LengthOfQuoted() : length_of_formula > 0 ? length_of_formula : LengthOfWord()};
  next_ = first + token.text.size();
  column_ += CountCharacters(token.text);
  if (variables_ && *first == '$') {
    if (const std::string* value = variables_->Find(token.text.substr(1)))
      token.variable = std::exchange(token.text, *value);
  }
  const bool stands_for_formula = !token.variable.empty() && token.text.starts_with('(') && token.text.ends_with(')');
  if (variables_ && (length_of_formula > 0 || stands_for_formula)) Evaluate(token);
  return token;
}

std::size_t Tokenizer::LengthOfWord() const {
  const char* behind = next_;
  while (behind != end_ && !IsSpace(*behind)) ++behind;
  if (behind[-1] == '\\' && IsJoint(behind - 1)) --behind;
  const std::string_view word(next_, static_cast<std::size_t>(behind - next_));
  return comments_ == Comments::hash ? WithoutComment(word).size() : word.size();
}

/// Returns the length up to the closing quote, or to the end of the line if that is missing.
std::size_t Tokenizer::LengthOfQuoted() const {
  const char* behind = next_ + 1;
  for (; behind != end_ && !EndsLine(*behind); ++behind) {
    if (*behind == '"') return static_cast<std::size_t>(behind + 1 - next_);
    if (*behind == '\\' && behind + 1 != end_ && !EndsLine(behind[1])) ++behind;
  }
  return static_cast<std::size_t>(behind - next_);
}

/// Returns the length up to the closing parenthesis, or up to the end of the line or a comment if that is missing.
/// Returns 0 if the word is not a formula but, for example, a file name: if it continues after the closing parenthesis,
/// or lacks one and does not start like a formula.
std::size_t Tokenizer::LengthOfFormula() const {
  int open = 0;
  const char* behind = next_;
  for (const char* at = next_; at != end_ && !EndsLine(*at) && *at != '#'; ++at) {
    open += (*at == '(') - (*at == ')');
    if (!IsSpace(*at)) behind = at + 1;
    if (open > 0) continue;
    const bool ends_word = behind == end_ || IsSpace(*behind) || *behind == '#';
    return ends_word ? static_cast<std::size_t>(behind - next_) : 0;
  }
  const bool may_be_formula = next_ + 1 != end_ && std::strchr(" \t0123456789.+-$(", next_[1]);
  return may_be_formula ? static_cast<std::size_t>(behind - next_) : 0;
}

void Tokenizer::Evaluate(Token& token) {
  const std::string_view formula = token.text;
  const bool is_in_file = token.variable.empty();
  if (is_in_file) token.variable = formula;
  try {
    token.text = variables_->Evaluate(formula);
  } catch (const R3::ExpressionError& error) {
    Token part = token;
    if (is_in_file) {
      part.variable = {};
      part.text = formula.substr(std::min(error.at, formula.size()), error.length);
      part.column += CountCharacters(formula.substr(0, error.at));
    }
    const std::string stands_for = Escaped(token.variable) + " stands for " + Escaped(formula) + ": ";
    mistakes_.push_back(ErrorAt(text_, part, (is_in_file ? "" : stands_for) + error.what(), error.hint));
    token.text = "1";
    token.is_broken = true;
  }
}

void Tokenizer::SkipWhiteSpace() {
  bool is_joined = false;
  for (; next_ != end_ && (IsSpace(*next_) || (*next_ == '\\' && IsJoint(next_))); ++next_) {
    ++column_;
    if (*next_ == '\\') is_joined = true;
    if (!EndsLine(*next_)) continue;
    if (*next_ == '\r' && next_ + 1 != end_ && next_[1] == '\n') ++next_;
    ++line_;
    column_ = 1;
    if (!is_joined) at_line_start_ = true;
    is_joined = false;
  }
}

/// Returns true if a backslash joins lines: it is followed only by blanks, which are easily overlooked, and the end of
/// the line or file.
bool Tokenizer::IsJoint(const char* backslash) const {
  if (joints_ == Joints::none) return false;
  const char* behind = backslash + 1;
  while (behind != end_ && IsSpace(*behind) && !EndsLine(*behind)) ++behind;
  return behind == end_ || EndsLine(*behind);
}

void Tokenizer::SkipToLineEnd() {
  while (next_ != end_ && !EndsLine(*next_)) ++next_;
}

}  // namespace ray
