#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace ray {

/// One mistake in a file, ready to print:
///
///     scenes/room.scn:14:1: error: unknown command 'spere'
///        14 | spere 0  0 1 0  0.5
///           | ^~~~~ did you mean 'sphere'?
///     included from scenes/main.scn:3
struct SceneError {
  std::string file;
  std::size_t line = 0, column = 0;        // from 1, in characters; 0 when the file as a whole is meant
  std::string message;                     // "unknown command 'spere'"
  std::string source_line;                 // the text of that line, without its end
  std::size_t length = 1;                  // characters to underline
  std::string hint;                        // behind the caret; may be empty
  std::vector<std::string> included_from;  // "scenes/main.scn:3", innermost first

  std::string Format() const;
};

/// Everything wrong with a scene, at most 20 mistakes of it in full, then a count. what() is the report.
class SceneErrors : public std::runtime_error {
 public:
  /// Readers give up after this many: a file of another kind would only keep failing.
  static constexpr std::size_t max_kept = 1000;

  explicit SceneErrors(std::vector<SceneError> all);
  const std::vector<SceneError>& All() const { return all_; }

 private:
  std::vector<SceneError> all_;
};

/// The mistakes and remarks collected while a scene is read.
class Report {
 public:
  /// Throws SceneErrors when there are too many to go on.
  void Error(SceneError error);
  /// One line, which is kept once however often it is said; beyond a hundred they are counted only.
  void Warn(const std::string& place, const std::string& message);

  /// Throws SceneErrors if there was any.
  void ThrowErrors();
  std::vector<std::string> Warnings() const;

 private:
  std::vector<SceneError> errors_;
  std::vector<std::string> warnings_;
  std::size_t warnings_left_out_ = 0;
};

}  // namespace ray
