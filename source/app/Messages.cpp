#include "source/app/Messages.h"

#include <unistd.h>

namespace ray {

void TellPart(const std::string& text) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
}

// One write a line: lines of several processes do not mix.
void Tell(const std::string& line) { TellPart(line + "\n"); }

void TellAll(std::span<const std::string> lines) {
  for (const std::string& line : lines) Tell(line);
}

}  // namespace ray
