#include "source/app/options/RayproCommand.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "source/app/options/ForeignOption.h"
#include "source/app/options/OptionTable.h"
#include "source/text/Words.h"

namespace ray {
namespace {

constexpr std::array<std::string_view, 7> of_the_run{"threads", "memory",          "checkpoint", "resume",
                                                     "restart", "keep_checkpoint", "reference"};

bool IsOfThePicture(const OptionKind& option) {
  const std::string_view topic = option.topic;
  return IsSetting(option) && topic != "messages" && topic != "batch" &&
         std::ranges::find(of_the_run, option.name) == of_the_run.end();
}

/// A file's name that is not taken for an option.
std::string AsName(const std::string& name) { return LooksLikeOption(name) || IsOfPovRay(name) ? "./" + name : name; }

}  // namespace

std::string RayproCommand(const Options& options) {
  std::vector<std::string> words{"raypro", AsName(options.scene), AsName(options.picture)};
  for (const OptionKind& option : OptionTable(Program::raypro)) {
    if (!IsOfThePicture(option)) continue;
    // What was typed may be the default, and the scene may state another.
    const auto typed =
        options.IsGiven(option.name) ? Typed(option, options) : Typed(option, options, Defaults(Program::raypro));
    words.insert(words.end(), typed.begin(), typed.end());
  }
  return ShellLine(words);
}

}  // namespace ray
