#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace ray {

/// One mistake in a file, as it is printed:
///
///     scenes/room.scn:14:1: error: unknown command 'spere'
///        14 | spere 0  0 1 0  0.5
///           | ^~~~~ did you mean 'sphere'?
///     included from scenes/main.scn:3
struct SceneError {
  std::string file;
  std::size_t line = 0, column = 0;        // 1-based, in characters; 0 for the file as a whole
  std::string message;                     // "unknown command 'spere'"
  std::string source_line;                 // the text of that line, without its end
  std::size_t length = 1;                  // characters to underline
  std::string hint;                        // after the caret; may be empty
  std::vector<std::string> included_from;  // "scenes/main.scn:3", innermost first

  std::string Format() const;
};

/// All mistakes in a scene: at most 20 in full, then a count. what() is the report.
class SceneErrors : public std::runtime_error {
 public:
  /// The number of mistakes after which readers stop: a file of another kind would only produce more.
  static constexpr std::size_t max_kept = 1000;

  explicit SceneErrors(std::vector<SceneError> all);
  const std::vector<SceneError>& All() const { return all_; }

 private:
  std::vector<SceneError> all_;
};

/// The mistakes and warnings collected while reading a scene.
class Report {
 public:
  /// Adds a mistake. Throws SceneErrors if there are too many to continue.
  void Error(SceneError error);
  /// Adds a warning, once per distinct line; after a hundred, further ones are only counted.
  void Warn(const std::string& place, const std::string& message);

  /// Throws SceneErrors if there was a mistake.
  void ThrowErrors();
  std::vector<std::string> Warnings() const;

 private:
  std::vector<SceneError> errors_;
  std::vector<std::string> warnings_;
  std::size_t warnings_omitted_ = 0;
};

}  // namespace ray
