#include "source/app/report/Messages.h"

#include <unistd.h>

#include "source/app/report/Terminal.h"

namespace ray {

void TellPart(const std::string& text) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
}

// One write a line: lines of several processes do not mix.
void PrintError(const std::string& line) { TellPart((HasColors() ? Colored(line) : line) + "\n"); }

void PrintFailure(const std::string& line) { TellPart((HasColors() ? ColoredFailure(line) : line) + "\n"); }

void TellAll(std::span<const std::string> lines) {
  for (const std::string& line : lines) PrintError(line);
}

}  // namespace ray
