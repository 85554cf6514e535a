#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// The position of a pixel in an image.
struct Pixel {
  int x = 0, y = 0;  // column from the left, row from the bottom
};

/// The parts of a command line that all programs share; each adds its own options.
struct Options {
  explicit Options(const Program& which) : program(&which) {}
  virtual ~Options() = default;

  const Program* program;
  std::vector<std::string> given;        // the options that were typed, by name without the dash
  std::vector<std::string> names;        // the words that are not options, as typed; without the command
  const CommandKind* command = nullptr;  // of a program that has commands
  const OptionKind* request = nullptr;   // the option that replaces the program's own work, or null
  std::string subject;                   // of the request: a topic, a course, an image or an output file
  std::vector<std::string> keys;         // descriptions of the keys of a window, for -list

  bool IsGiven(const std::string& option) const { return std::ranges::find(given, option) != given.end(); }
  /// Returns true if the request is the option with that name.
  bool Asks(const char* name) const;
  /// Returns the current value as it would be typed; empty if there is none.
  std::string Show(const OptionKind& option) const;
  /// Returns the words that give another program the current value: "-motion", "0", "1", "0". Empty if there is no
  /// value, or if it is the program's default and was not typed; a typed value may be the default, and a scene may set
  /// another one.
  std::vector<std::string> TypedFor(const Program& reader, const OptionKind& option) const;
  /// Returns the end of a message that begins with "-focus has no effect": "without -aperture and -sampler grid". Empty
  /// if the option has an effect.
  std::string WhyWithoutEffect(const OptionKind& option) const;
};

/// Returns the options as those of the program to which a row of its table belongs. Throws std::bad_cast for those of
/// another one.
template <class Own>
const Own& As(const Options& options) {
  return dynamic_cast<const Own&>(options);
}
template <class Own>
Own& As(Options& options) {
  return dynamic_cast<Own&>(options);
}

}  // namespace ray
