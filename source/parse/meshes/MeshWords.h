#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "R3/Point.h"
#include "R3/Vector.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"
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
  MeshWords(const Text& text, Tokenizer::Comments comments, Tokenizer::Joints joints = Tokenizer::Joints::none)
      : tokens_(text, comments, joints) {}

  bool AtEnd() { return !tokens_.Peek(); }
  const std::optional<Token>& Peek() { return tokens_.Peek(); }
  std::optional<Token> Next();
  Token Need(const Part& part);
  /// NaN for a word that says NaN or infinity.
  double AnyNumber(const Part& part);
  /// At most 1e150 in magnitude.
  double Coordinate(const Part& part);
  R3::Point Place(const char* of, std::size_t number);
  /// A number that the mesh can do without: nothing where it is NaN, infinite, or beyond 1e150 in magnitude.
  std::optional<double> NumberIfUsable(const Part& part);
  /// Three of them: nothing where one is missing.
  std::optional<R3::Vector> VectorIfUsable(const char* of, std::size_t number);
  std::int64_t Whole(const Part& part);
  /// The whole number that a word read before says.
  std::int64_t WholeIn(const Token& word, const Part& part) const;
  /// A whole number in [0, below).
  std::uint32_t Index(const Part& part, std::size_t below);

  /// Whether another word follows on the line of the last one.
  bool HasMoreOnLine();
  bool NextIs(std::string_view word) { return !AtEnd() && Peek()->text == word; }
  /// What follows the last word on its line, as it stands, blanks within it and what looks like a comment included: a
  /// name. Passes over its words.
  Token RestOfLine();
  /// How many words were left on the line of the last one.
  std::size_t SkipLine() { return tokens_.SkipLine(last_.line); }
  /// How many lines with words follow the line of the last one; looks through the rest of the file.
  std::size_t LinesLeft() const;
  std::size_t BytesLeft() const { return tokens_.BytesLeft(); }
  const Token& Last() const { return last_; }
  const Text& Source() const { return tokens_.Source(); }

  [[noreturn]] void Fail(const Token& at, const std::string& message, const std::string& hint = {}) const;

 private:
  Tokenizer tokens_;
  Token last_;
};

/// Counts what is odd about a file and remembers where it was seen first, for one warning about all of it.
class Tally {
 public:
  /// `where` is of no line in a binary file.
  void Add(const Token& where) {
    if (count_++ == 0) first_ = where;
  }
  bool IsEmpty() const { return count_ == 0; }
  const Token& First() const { return first_; }

  /// "a.off:5:1: warning: 3 faces skipped, the first of them here" for one = "face skipped", many = "faces skipped".
  /// Nothing when nothing was counted.
  void Warn(const Text& file, Report& report, const std::string& one, const std::string& many) const;

 private:
  std::size_t count_ = 0;
  Token first_;
};

/// Warns of normals and texture coordinates that are no finite numbers, or too large, and so were left out.
void WarnOfAbsent(const Tally& normals, const Tally& uvs, const Text& file, Report& report);

}  // namespace ray
