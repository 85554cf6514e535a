#pragma once

#include <span>
#include <string>

namespace ray {

/// Writes a line to standard error, in colors if that is a terminal. If it is full or closed, only the message is lost.
void PrintError(const std::string& line);
/// Prints a line about the error that ends the program.
void PrintFailure(const std::string& line);
void PrintLines(std::span<const std::string> lines);
/// Writes a line "file: warning: ..." for each of the warnings about a file.
void PrintWarnings(const std::string& file, std::span<const std::string> warnings);
/// Writes text to standard error without an end of line.
void PrintErrorPart(const std::string& text);

/// Returns true if standard error is a terminal that can move its cursor; one whose TERM is dumb, or not set, cannot.
bool HasTerminal();
/// Returns true if it may also get colors: NO_COLOR forbids them (no-color.org).
bool HasColors();

/// Returns a message with terminal colors: "error:" red, "warning:" yellow, the caret and its underline green. A line
/// with neither word that begins with a program's name stays uncolored.
std::string Colored(const std::string& message);

/// Returns "raypro: -width must be..." with the name in red, for a message that ends the program.
std::string ColoredFailure(const std::string& message);

}  // namespace ray
