#include "source/app/report/Messages.h"

#include <unistd.h>

#include "source/app/report/Terminal.h"
#include "source/text/Quoting.h"

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

void PrintWarnings(const std::string& file, std::span<const std::string> warnings) {
  for (const std::string& warning : warnings) PrintError(Escaped(file) + ": warning: " + warning);
}

}  // namespace ray
