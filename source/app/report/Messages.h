#pragma once

#include <span>
#include <string>

namespace ray {

/// Writes a line to standard error. One that is full or closed costs the message and nothing else.
void PrintError(const std::string& line);
void TellAll(std::span<const std::string> lines);
/// The same without an end of line.
void TellPart(const std::string& text);

}  // namespace ray
