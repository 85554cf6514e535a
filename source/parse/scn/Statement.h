#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "R3/ShapeKind.h"
#include "source/parse/Tokenizer.h"
#include "source/parse/scn/Command.h"

namespace ray {

/// Numbers and the words they were read from.
struct Arguments {
  std::vector<double> values;
  std::vector<Token> words;
};

/// The name of a file, and its word.
struct FileWord {
  Token word;
  std::string name;
};

/// One command while its arguments are read. A wrong argument is recorded and reading continues, so that one run
/// reports all mistakes in a line; a missing one ends the command. The effects of a statement with errors do not
/// matter, since the scene is rejected.
class Statement {
 public:
  /// Thrown if the command ends before its arguments do; the error has been recorded.
  struct Incomplete {};

  Statement(const Command& command, const Token& word, Tokenizer& tokens)
      : command_(command), word_(word), tokens_(tokens), name_(command.name), usage_(command.usage) {}

  /// Starts a part of the command: missing arguments are reported with this name and usage, which must outlive the
  /// statement.
  void BeginPart(std::string_view name, std::string_view usage) { name_ = name, usage_ = usage; }

  /// Reads the wanted arguments, all numbers.
  Arguments Numbers(std::span<const R3::Argument> wanted);
  /// Reads numbers within the range of coordinates.
  Arguments Coordinates(std::span<const R3::Argument> wanted);
  /// Reads the word of an argument that is not a number.
  Token Word(const char* name);
  /// Reads the name of a file, which may be quoted.
  FileWord FileName(const char* name = "file name");
  /// Returns the next word without consuming it.
  const std::optional<Token>& Peek() { return tokens_.Peek(); }
  /// Returns the remaining words of the line.
  std::vector<Token> RestOfLine();
  /// Returns true if the next word is this one, and consumes it.
  bool Takes(std::string_view word);
  /// Returns and consumes the next word if it is, or was meant as, a number; no statement begins with one.
  std::optional<Token> TakesNumber();

  void Error(const Token& at, std::string message, std::string hint = {});
  const Command& What() const { return command_; }
  const Token& CommandWord() const { return word_; }
  bool IsGood() const { return errors_.empty() && tokens_.Mistakes().empty(); }
  /// Returns all mistakes, formulas without a value first.
  std::vector<SceneError> Errors() &&;

 private:
  const Command& command_;
  const Token word_;
  Tokenizer& tokens_;
  std::string_view name_, usage_;
  std::vector<SceneError> errors_;
};

/// Returns true if a word can only start the next statement: a command, or a word that starts a line like one.
bool BeginsStatement(const Token& token);

}  // namespace ray
