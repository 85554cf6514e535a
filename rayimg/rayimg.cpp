// rayimg compares, describes, converts, arranges and merges images, and makes movies of them. Its commands and their
// options are in Table.cpp.
#include <map>
#include <string>
#include <vector>

#include "rayimg/Commands.h"
#include "source/app/Answers.h"
#include "source/app/GuardedMain.h"
#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/OptionTable.h"
#include "source/text/Words.h"

namespace ray {
namespace {

const std::map<std::string, int (*)(const rayimg::ImageOptions& options, const std::string& command_line)> commands{
    {"diff", rayimg::Diff},
    {"info", rayimg::Info},
    {"extract", rayimg::Extract},
    {"convert", rayimg::Convert},
    {"resize", rayimg::Resize},
    {"crop", rayimg::Crop},
    {"side-by-side", rayimg::SideBySide},
    {"contact-sheet", rayimg::ContactSheet},
    {"merge", rayimg::Merge},
    {"movie", rayimg::Movie},
};

int Run(const std::vector<std::string>& words) {
  const auto options = ReadCommandLine<rayimg::ImageOptions>(Program::rayimg, words);
  if (!options.request) return commands.at(options.command->name)(options, "rayimg " + ShellLine(words));
  AnswerRequest(options);
  return status::done;
}

}  // namespace
}  // namespace ray

int main(int argc, char** argv) { return ray::GuardedMain(ray::Program::rayimg, argc, argv, ray::Run); }
