#include "source/parse/scn/Statement.h"

#include <iterator>

#include "R3/Expression.h"
#include "source/parse/Coordinate.h"
#include "source/parse/scn/QuotedName.h"
#include "source/text/Number.h"

namespace ray {
namespace {

bool IsLetter(char c) { return ((c | 0x20) >= 'a' && (c | 0x20) <= 'z') || c == '_'; }

/// Returns true for NaN and infinities, which are meant as numbers but look like words.
bool LooksLikeNumber(std::string_view word) { return word.starts_with("nan") || word.starts_with("inf"); }

/// Returns true if the word would be a formula in parentheses: "1/2", "$a+1".
bool IsArithmetic(std::string_view word) {
  const std::size_t behind_signs = word.find_first_not_of("+-");
  if (word.find_first_of("+-*/^(", behind_signs) == std::string_view::npos) return false;
  try {
    R3::Evaluate(word, [](std::string_view) { return 0.5; });
    return true;
  } catch (const R3::ExpressionError&) {
    return false;
  }
}

}  // namespace

bool BeginsStatement(const Token& token) {
  if (!IsLetter(token.text[0])) return false;  // avoids the search for most words
  return FindCommand(token.text) || (token.starts_line && !LooksLikeNumber(token.text));
}

Arguments Statement::Numbers(std::span<const R3::Argument> wanted) {
  Arguments read;
  read.values.reserve(wanted.size());
  read.words.reserve(wanted.size());
  for (const R3::Argument& argument : wanted) {
    if (const auto& next = tokens_.Peek(); !next || BeginsStatement(*next)) {
      const std::string color = HexColorHint(tokens_.Source(), read.words.empty() ? word_ : read.words.back());
      Error(word_, std::string(name_) + ": " + argument.name + " is missing",
            color.empty() ? std::string(usage_) : color);
      throw Incomplete{};
    }
    const Token word = *tokens_.Next();
    const auto [value, problem] = ParseNumber(word.text);
    if (problem)
      Error(word, std::string(argument.name) + " " + problem + ", got " + Quoted(word.text));
    else if (value < 0 && !argument.may_be_negative)
      Error(word, std::string(argument.name) + " must not be negative, got " + Escaped(word.text));
    read.values.push_back(value);
    read.words.push_back(word);
  }
  return read;
}

Arguments Statement::Coordinates(std::span<const R3::Argument> wanted) {
  Arguments read = Numbers(wanted);
  for (std::size_t i = 0; i < read.values.size() && IsGood(); ++i)
    if (!IsCoordinate(read.values[i]))
      Error(read.words[i],
            std::string(wanted[i].name) + " must not exceed 1e150 in magnitude, got " + Escaped(read.words[i].text));
  return read;
}

// A file may have the name of a command, but hardly at the start of a line.
Token Statement::Word(const char* name) {
  const auto& next = tokens_.Peek();
  if (!next || (next->starts_line && FindCommand(next->text))) {
    Error(word_, std::string(name_) + ": " + name + " is missing", std::string(usage_));
    throw Incomplete{};
  }
  return *tokens_.Next();
}

FileWord Statement::FileName(const char* name) {
  const Token word = Word(name);
  auto [text, problem] = Unquoted(word.text);
  if (problem) {
    Error(word, problem, quoting_rules);
    throw Incomplete{};
  }
  return {word, std::move(text)};
}

std::vector<Token> Statement::RestOfLine() {
  std::vector<Token> words;
  while (tokens_.Peek() && !tokens_.Peek()->starts_line) words.push_back(*tokens_.Next());
  return words;
}

bool Statement::Takes(std::string_view word) {
  const auto& next = tokens_.Peek();
  if (!next || next->text != word) return false;
  tokens_.Next();
  return true;
}

std::optional<Token> Statement::TakesNumber() {
  const auto& next = tokens_.Peek();
  if (!next || next->starts_line || (ParseNumber(next->text).problem && !SaysNanOrInfinity(next->text))) return {};
  return tokens_.Next();
}

std::vector<SceneError> Statement::Errors() && {
  std::vector<SceneError> all = tokens_.TakeMistakes();
  all.insert(all.end(), std::make_move_iterator(errors_.begin()), std::make_move_iterator(errors_.end()));
  return all;
}

void Statement::Error(const Token& at, std::string message, std::string hint) {
  if (at.is_broken) return;
  if (hint.empty() && message.find(" must be ") != message.npos && IsArithmetic(at.text))
    hint = "arithmetic needs parentheses: (" + Escaped(at.text) + ")";
  else if (hint.empty() && at.text.starts_with('$'))
    hint = Variables::IsName(at.text.substr(1)) ? "it is not defined: use 'define " + std::string(at.text.substr(1)) +
                                                      " 0.5', or -define " + std::string(at.text.substr(1)) + "=0.5"
                                                : "names of variables consist of a to z, A to Z, 0 to 9 and _";
  else if (hint.empty() && !at.variable.empty())
    hint = "that is what " + Escaped(at.variable) + " stands for";
  errors_.push_back(ErrorAt(tokens_.Source(), at, std::move(message), std::move(hint)));
}

}  // namespace ray
