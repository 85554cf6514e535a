#pragma once

#include <deque>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace ray {

/// Returns true for "name=value", where the name consists of letters, digits and _, and the value is not empty.
bool IsDefinition(const std::string& text);

/// Words of a scene that the command line may set, so that one file makes every frame of a movie: $t stands for the
/// value of t. The first definition of a variable counts: the command line, then the scene, file by file.
class Variables {
 public:
  static bool IsName(std::string_view text);

  /// Makes variables from definitions, see IsDefinition; the last of several for one name counts, as usual on command
  /// lines.
  explicit Variables(std::span<const std::string> definitions);

  /// Defines a variable unless it already has a value.
  void Define(std::string_view name, std::string_view value);
  /// Returns a pointer to the value, which remains valid, or null.
  const std::string* Find(std::string_view name);
  /// Returns the value of an arithmetic formula in which $name stands for a numeric variable, as text that remains
  /// valid. Throws R3::ExpressionError.
  const std::string& Evaluate(std::string_view formula);
  /// Returns the names that the command line defines and the scene does not use.
  const std::set<std::string>& Unused() const { return unused_; }

 private:
  std::map<std::string, std::string, std::less<>> values_;
  std::set<std::string> unused_;
  std::deque<std::string> evaluated_;
};

}  // namespace ray
