#include "source/app/report/Messages.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "source/text/Quoting.h"

namespace ray {
namespace {

// ECMA-48, Select Graphic Rendition.
constexpr const char* red = "\033[1;31m";
constexpr const char* yellow = "\033[1;33m";
constexpr const char* green = "\033[1;32m";
constexpr const char* no_color = "\033[0m";

bool IsSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value;
}

std::string Painted(const std::string& line, std::size_t begin, std::size_t length, const char* color) {
  return line.substr(0, begin) + color + line.substr(begin, length) + no_color + line.substr(begin + length);
}

/// Returns the position of the caret in a line such as "      | ^~~~ did you mean"; npos in any other.
std::size_t CaretIn(const std::string& line) {
  const std::size_t bar = line.find_first_not_of(' ');
  if (bar == std::string::npos || line.compare(bar, 2, "| ") != 0) return std::string::npos;
  const std::size_t caret = line.find_first_not_of(" \t", bar + 1);
  return caret != std::string::npos && line[caret] == '^' ? caret : std::string::npos;
}

std::string ColoredLine(const std::string& line) {
  if (const std::size_t caret = CaretIn(line); caret != std::string::npos) {
    const std::size_t end = std::min(line.find_first_not_of('~', caret + 1), line.size());
    return Painted(line, caret, end - caret, green);
  }
  for (const auto& [word, color] : {std::pair{std::string_view("error:"), red}, {std::string_view("warning:"), yellow}})
    if (const std::size_t at = line.find(": " + std::string(word) + " "); at != std::string::npos)
      return Painted(line, at + 2, word.size(), color);
  return line;
}

}  // namespace

bool HasTerminal() {
  const char* const terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) && terminal && *terminal && std::string_view(terminal) != "dumb";
}

bool HasColors() { return HasTerminal() && !IsSet("NO_COLOR"); }

std::string Colored(const std::string& message) {
  std::string colored;
  for (std::size_t begin = 0; begin < message.size();) {
    const std::size_t end = std::min(message.find('\n', begin), message.size());
    colored += ColoredLine(message.substr(begin, end - begin));
    if (end < message.size()) colored += '\n';
    begin = end + 1;
  }
  return colored;
}

std::string ColoredFailure(const std::string& message) {
  const std::string colored = Colored(message);
  const std::size_t name = message.find(": ");
  return colored == message && name != std::string::npos ? Painted(message, 0, name + 1, red) : colored;
}

void PrintErrorPart(const std::string& text) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
}

// One write per line, so that lines of several processes do not mix.
void PrintError(const std::string& line) { PrintErrorPart((HasColors() ? Colored(line) : line) + "\n"); }

void PrintFailure(const std::string& line) { PrintErrorPart((HasColors() ? ColoredFailure(line) : line) + "\n"); }

void PrintLines(std::span<const std::string> lines) {
  for (const std::string& line : lines) PrintError(line);
}

void PrintWarnings(const std::string& file, std::span<const std::string> warnings) {
  for (const std::string& warning : warnings) PrintError(Escaped(file) + ": warning: " + warning);
}

}  // namespace ray
