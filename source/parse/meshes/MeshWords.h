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

/// Returns "7 bytes follow".
std::string BytesThatFollow(std::size_t bytes);

/// A reader of the words of a text mesh file. All functions throw SceneError with the position in the file.
class MeshWords {
 public:
  MeshWords(const Text& text, Tokenizer::Comments comments, Tokenizer::Joints joints = Tokenizer::Joints::none)
      : tokens_(text, comments, joints) {}

  bool AtEnd() { return !tokens_.Peek(); }
  const std::optional<Token>& Peek() { return tokens_.Peek(); }
  std::optional<Token> Next();
  Token Need(const Part& part);
  /// Reads a number; NaN for a word that means NaN or infinity.
  double AnyNumber(const Part& part);
  /// Reads a number of at most 1e150 in magnitude.
  double Coordinate(const Part& part);
  R3::Point Place(const char* of, std::size_t number);
  /// Reads an optional number; std::nullopt if it is NaN, infinite, or above 1e150 in magnitude.
  std::optional<double> NumberIfUsable(const Part& part);
  /// Reads three of them; std::nullopt if one is not usable.
  std::optional<R3::Vector> VectorIfUsable(const char* of, std::size_t number);
  std::int64_t Whole(const Part& part);
  /// Returns the integer in a word that was already read.
  std::int64_t WholeIn(const Token& word, const Part& part) const;
  /// Reads an integer in [0, below).
  std::uint32_t Index(const Part& part, std::size_t below);

  /// Returns true if another word follows on the line of the last one.
  bool HasMoreOnLine();
  bool NextIs(std::string_view word) { return !AtEnd() && Peek()->text == word; }
  /// Reads the unchanged text after the last word on its line as a name, including blanks and apparent comments. Skips
  /// its words.
  Token RestOfLine();
  /// Skips the rest of the last word's line and returns the number of words.
  std::size_t SkipLine() { return tokens_.SkipLine(last_.line); }
  /// Returns the number of nonempty lines after the line of the last word; scans the rest of the file.
  std::size_t LinesLeft() const;
  std::size_t BytesLeft() const { return tokens_.BytesLeft(); }
  const Token& Last() const { return last_; }
  const Text& Source() const { return tokens_.Source(); }

  [[noreturn]] void Fail(const Token& at, const std::string& message, const std::string& hint = {}) const;

 private:
  Tokenizer tokens_;
  Token last_;
};

/// Counts oddities of a file and remembers the first position, for one warning about all of them.
class Tally {
 public:
  /// Counts one oddity; `where` has no line in a binary file.
  void Add(const Token& where) {
    if (count_++ == 0) first_ = where;
  }
  bool IsEmpty() const { return count_ == 0; }
  const Token& First() const { return first_; }

  /// Warns "a.off:5:1: warning: 3 faces skipped, the first of them here" for one = "face skipped", many = "faces
  /// skipped". Does nothing if nothing was counted.
  void Warn(const Text& file, Report& report, const std::string& one, const std::string& many) const;

 private:
  std::size_t count_ = 0;
  Token first_;
};

/// Warns about normals and texture coordinates that are not finite, or too large, and were therefore ignored.
void WarnOfAbsent(const Tally& normals, const Tally& uvs, const Text& file, Report& report);

}  // namespace ray
