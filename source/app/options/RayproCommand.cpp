#include "source/app/options/RayproCommand.h"

#include <string>
#include <string_view>
#include <vector>

#include "source/app/options/OptionTable.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// Returns true if the option belongs in the command that reproduces the image.
bool MakesTheImage(const OptionKind& option) {
  return option.facts.HasAny({Fact::image, Fact::samples, Fact::budget, Fact::speed, Fact::reading}) &&
         !option.facts.Has(Fact::run);
}

/// Returns a file name that cannot be mistaken for an option.
std::string AsName(const std::string& name) { return LooksLikeOption(name) ? "./" + name : name; }

}  // namespace

std::string RayproCommand(const RenderOptions& options) {
  std::vector<std::string> words{"raypro", AsName(options.files.scene), AsName(options.files.image)};
  bool has_size = *options.program == Program::raypro;  // a window may have raypro's default, see DefaultImage
  for (const OptionKind& option : OptionTable(Program::raypro)) {
    if (!MakesTheImage(option)) continue;
    const auto typed = options.TypedFor(Program::raypro, option);
    words.insert(words.end(), typed.begin(), typed.end());
    const std::string_view name = option.name;
    has_size |= !typed.empty() && (name == "width" || name == "height");
  }
  if (!has_size) words.insert(words.end(), {"-width", std::to_string(options.render.width)});
  return ShellLine(words);
}

}  // namespace ray
