#pragma once

#include <cstdint>
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

/// The name of a file, and the word that says it.
struct FileWord {
  Token word;
  std::string name;
};

/// One command while its arguments are read. A wrong argument is noted and reading goes on, so that one run tells all
/// that is wrong with a line; a missing one ends the command. What a statement with errors leaves in the scene does not
/// matter: the scene is refused.
class Statement {
 public:
  /// Thrown when the command ends before its arguments do; the error has been noted.
  struct Incomplete {};

  Statement(const Command& command, const Token& word, Tokenizer& tokens)
      : command_(command), word_(word), tokens_(tokens), name_(command.name), usage_(command.usage) {}

  /// What lacks from here on is said of this word of the command, and of how that one is used.
  /// Name and usage must outlive the statement.
  void BeginPart(std::string_view name, std::string_view usage) { name_ = name, usage_ = usage; }

  /// Reads the arguments that are wanted, all numbers.
  Arguments Numbers(std::span<const R3::Argument> wanted);
  /// Reads numbers, none of them beyond what coordinates may be.
  Arguments Coordinates(std::span<const R3::Argument> wanted);
  /// The word of an argument that is no number.
  Token Word(const char* name);
  /// The name of a file, which may stand in quotes.
  FileWord FileName(const char* name = "file name");
  /// The word that comes next, without taking it.
  const std::optional<Token>& Peek() { return tokens_.Peek(); }
  /// The words that are left on the line.
  std::vector<Token> RestOfLine();
  /// Whether the next word is this one, which is then taken.
  bool Takes(std::string_view word);
  /// The next word if it is, or was meant as, a number, which then is taken; no statement begins with one.
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

/// Whether a word can only be the beginning of the next statement: a command, or a word that starts a line like one.
bool BeginsStatement(const Token& token);

}  // namespace ray
