#include "source/parse/courses/comp30019/Line.h"

#include "source/parse/Tokenizer.h"
#include "source/text/Number.h"

namespace ray::comp30019 {
namespace {

constexpr std::string_view marks = ",\"()";

bool IsMark(std::string_view token) { return token.size() == 1 && marks.find(token[0]) != std::string_view::npos; }

/// Splits a word at its punctuation.
void Cut(Token word, std::vector<Token>& tokens) {
  while (!word.text.empty()) {
    const std::size_t mark = std::min(word.text.find_first_of(marks), word.text.size());
    const std::size_t bytes = mark == 0 ? 1 : mark;
    Token token = word;
    token.text = word.text.substr(0, bytes);
    tokens.push_back(token);
    word.text.remove_prefix(bytes);
    word.column += CountCharacters(token.text);
  }
}

}  // namespace

std::vector<std::vector<Token>> TokensByLine(const Text& text) {
  std::vector<std::vector<Token>> lines;
  Tokenizer words(text, Tokenizer::Comments::none);
  while (const auto word = words.Next()) {
    if (word->starts_line || lines.empty()) lines.emplace_back();
    Cut(*word, lines.back());
  }
  return lines;
}

Token Line::Next(const std::string& what) {
  if (next_ == tokens_.size()) Stop(Command(), std::string(Command().text) + ": " + what + " is missing");
  return tokens_[next_++];
}

void Line::Expect(std::string_view mark, const std::string& where, const std::string& what) {
  const std::string quoted = "'" + std::string(mark) + "'";
  const Token token = Next(what.empty() ? quoted + " " + where : what);
  if (token.text != mark) Stop(token, "expected " + quoted + " " + where + ", got " + Quoted(token.text));
}

Token Line::Name(const char* what) {
  const std::string name = std::string("the ") + what;
  Expect("\"", "before " + name, what);
  const Token token = Next(what);
  if (token.text == "\"") Stop(token, std::string(what) + " must not be empty");
  if (IsMark(token.text)) Stop(token, std::string(what) + " must not contain " + Quoted(token.text));
  const Token end = Next("'\"' behind " + name);
  if (end.text == "\"") return token;
  if (IsMark(end.text)) Stop(end, std::string(what) + " must not contain " + Quoted(end.text));
  Stop(end, std::string(what) + " must be one word, in quotes");
}

Token Line::Word(const char* what) {
  const Token token = Next(what);
  if (!IsMark(token.text)) return token;
  Stop(token, std::string("expected the ") + what + ", got " + Quoted(token.text));
}

Number Line::Real(const char* what) { return RealNamed(what); }

Number Line::RealNamed(const std::string& what) {
  const Token token = Next(what);
  if (IsMark(token.text)) Stop(token, "expected " + what + ", got " + Quoted(token.text));
  const auto [value, problem] = ParseNumber(token.text);
  if (problem) Error(token, what + " " + problem + ", got " + Quoted(token.text));
  return {value, token};
}

Triple Line::Vector(const char* what, std::string_view parts) {
  const std::string name = std::string("the ") + what;
  Triple triple;
  Expect("(", "before " + name, what);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string part = std::string(1, parts[i]) + " of " + name;
    if (i > 0) Expect(",", "before " + part, part);
    triple[i] = RealNamed(part);
  }
  Expect(")", "behind " + name, {});
  return triple;
}

void Line::Stop(const Token& at, std::string message) {
  Error(at, std::move(message), usage_);
  throw Incomplete{};
}

void Line::Error(const Token& at, std::string message, std::string hint) {
  errors_.push_back(ErrorAt(text_, at, std::move(message), std::move(hint)));
}

}  // namespace ray::comp30019
