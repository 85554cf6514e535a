#include "source/app/options/RayproCommand.h"

#include <vector>

#include "source/app/options/OptionTable.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// Whether the option belongs into the command that makes the same image again.
bool MakesTheImage(const OptionKind& option) {
  return option.facts.HasAny({Fact::image, Fact::samples, Fact::budget, Fact::speed, Fact::reading}) &&
         !option.facts.Has(Fact::run);
}

/// A file's name that is not taken for an option.
std::string AsName(const std::string& name) { return LooksLikeOption(name) ? "./" + name : name; }

}  // namespace

std::string RayproCommand(const RenderOptions& options) {
  std::vector<std::string> words{"raypro", AsName(options.files.scene), AsName(options.files.picture)};
  for (const OptionKind& option : OptionTable(Program::raypro)) {
    if (!MakesTheImage(option)) continue;
    const auto typed = options.TypedFor(Program::raypro, option);
    words.insert(words.end(), typed.begin(), typed.end());
  }
  return ShellLine(words);
}

}  // namespace ray
