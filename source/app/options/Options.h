#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// The place of a pixel in an image.
struct Pixel {
  int x = 0, y = 0;  // column from the left, row from the bottom
};

/// What a command line says to any of the programs; each has its own options beside these.
struct Options {
  explicit Options(const Program& which) : program(&which) {}
  virtual ~Options() = default;

  const Program* program;
  std::vector<std::string> given;        // the options that were typed, by name and without the dash
  std::vector<std::string> names;        // the words that are no options, as typed; without the command
  const CommandKind* command = nullptr;  // of a program that has commands
  const OptionKind* request = nullptr;   // the option that asks for something else than the program's own work
  std::string subject;                   // of the request: a topic, a course, an image or a file to write
  std::vector<std::string> keys;         // lines on the keys of a window, for -list

  bool IsGiven(const std::string& option) const { return std::ranges::find(given, option) != given.end(); }
  /// Whether the option of that name is the request.
  bool Asks(const char* name) const;
  /// The value in force, as it would be typed; empty when there is none.
  std::string Show(const OptionKind& option) const;
  /// The words that ask a program for the value in force: "-motion", "0", "1", "0". None when there is no value, or
  /// when it is the program's default and was not typed; what was typed may be the default, and a scene state another
  /// value.
  std::vector<std::string> TypedFor(const Program& reader, const OptionKind& option) const;
  /// Ends the sentence that begins with "-focus has no effect": "without -aperture and -sampler grid". Empty where the
  /// option has an effect.
  std::string WhyWithoutEffect(const OptionKind& option) const;
};

/// Options of the program to which a row of its table belongs. Throws std::bad_cast for those of another one.
template <class Own>
const Own& As(const Options& options) {
  return dynamic_cast<const Own&>(options);
}
template <class Own>
Own& As(Options& options) {
  return dynamic_cast<Own&>(options);
}

}  // namespace ray
