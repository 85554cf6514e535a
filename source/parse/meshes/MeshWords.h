#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "R3/Point.h"
#include "source/parse/Tokenizer.h"

namespace ray {

/// A part of a mesh, for messages: "x of vertex 12", or the name alone.
struct Part {
  const char* name;
  const char* of = nullptr;
  std::size_t number = 0;

  std::string Words() const {
    return of ? std::string(name) + " of " + of + " " + std::to_string(number) : std::string(name);
  }
};

/// "7 bytes follow"
std::string BytesThatFollow(std::size_t bytes);

/// The words of a mesh file in text form. Everything throws SceneError with the place in the file.
class MeshWords {
 public:
  MeshWords(const Text& text, Tokenizer::Comments comments) : tokens_(text, comments) {}

  bool AtEnd() { return !tokens_.Peek(); }
  std::optional<Token> Next();
  Token Need(const Part& part);
  double Number(const Part& part);
  /// At most 1e150 in magnitude.
  double Coordinate(const Part& part);
  R3::Point Place(const char* of, std::size_t number);
  std::int64_t Whole(const Part& part);
  /// A whole number in [0, below).
  std::uint32_t Index(const Part& part, std::size_t below);

  /// Whether another word follows on the line of the last one.
  bool HasMoreOnLine();
  bool NextIs(std::string_view word) { return !AtEnd() && tokens_.Peek()->text == word; }
  /// How many words were left on the line of the last one.
  std::size_t SkipLine() { return tokens_.SkipLine(last_.line); }
  std::size_t BytesLeft() const { return tokens_.BytesLeft(); }
  const Token& Last() const { return last_; }
  const Text& Source() const { return tokens_.Source(); }

  [[noreturn]] void Fail(const Token& at, const std::string& message, const std::string& hint = {}) const;

 private:
  Tokenizer tokens_;
  Token last_;
};

}  // namespace ray
