// Words are lines of the input; the first byte chooses the program.
#include <sstream>

#include "fuzz/Fuzz.h"
#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (size == 0) return 0;
  const ray::Program programs[] = {ray::Program::raypro, ray::Program::rayview, ray::Program::rayimg};
  std::istringstream text(std::string(reinterpret_cast<const char*>(data + 1), size - 1));
  std::vector<std::string> words;
  for (std::string line; std::getline(text, line);) words.push_back(line);
  try {
    ray::ReadCommandLine(programs[data[0] % 3], words);
  } catch (const ray::UsageError&) {
  }
  return 0;
}
