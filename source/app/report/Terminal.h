#pragma once

#include <string>

namespace ray {

/// Whether standard error is a terminal that can move its cursor; one whose TERM is dumb, or not set, cannot.
bool HasTerminal();
/// Whether it may also be given colors: NO_COLOR forbids them (no-color.org).
bool HasColors();

/// A message with its colors, as a terminal takes them: "error:" red, "warning:" yellow, the caret and what it
/// underlines green. Of a line that says neither and begins with a program's name nothing is colored.
std::string Colored(const std::string& message);

/// "raypro: -width must be..." with the name in red, for a message that ends the program.
std::string ColoredFailure(const std::string& message);

}  // namespace ray
