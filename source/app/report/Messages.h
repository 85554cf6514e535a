#pragma once

#include <span>
#include <string>

namespace ray {

/// Writes a line to standard error, in colors if that is a terminal. One that is full or closed costs the message and
/// nothing else.
void PrintError(const std::string& line);
/// Prints a line about what ends the program.
void PrintFailure(const std::string& line);
void TellAll(std::span<const std::string> lines);
/// Writes a line "file: warning: ..." for each of the warnings about a file.
void PrintWarnings(const std::string& file, std::span<const std::string> warnings);
/// Prints text without an end of line.
void TellPart(const std::string& text);

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
