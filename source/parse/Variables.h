#pragma once

#include <deque>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace ray {

/// "name=value", where the name is of letters, digits and _, and the value is not empty.
bool IsDefinition(const std::string& text);

/// Words of a scene that the command line may set, so that one file makes every frame of a movie: $t stands for the
/// value of t. Whoever names a variable first decides: the command line, then the scene, file by file.
class Variables {
 public:
  static bool IsName(std::string_view text);

  /// Each of them a definition, as IsDefinition says; of two for one name the last counts, as in command lines.
  explicit Variables(std::span<const std::string> definitions);

  /// Nothing is changed where the name has a value.
  void Define(std::string_view name, std::string_view value);
  /// The value, which stays in place; null where there is none.
  const std::string* Find(std::string_view name);
  /// Returns the value of an arithmetic formula in which $name stands for a variable that is a number, as text that
  /// stays in place. Throws R3::ExpressionError.
  const std::string& Evaluate(std::string_view formula);
  /// Names that the command line gives a value and the scene does not use.
  const std::set<std::string>& Unused() const { return unused_; }

 private:
  std::map<std::string, std::string, std::less<>> values_;
  std::set<std::string> unused_;
  std::deque<std::string> evaluated_;
};

}  // namespace ray
