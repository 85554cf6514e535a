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

}  // namespace ray
