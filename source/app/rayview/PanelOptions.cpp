#include "source/app/rayview/PanelOptions.h"

#include <string_view>

#include "source/app/options/CommandLine.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/RenderChecks.h"
#include "source/app/options/SceneSettings.h"
#include "source/text/Words.h"

namespace ray {
namespace {

bool IsInPanels(const OptionKind& option) {
  return option.facts.HasAny({Fact::image, Fact::samples, Fact::budget, Fact::speed}) &&
         !option.facts.Has(Fact::reading);
}

/// Returns the words after the option's name; a file name may contain blanks.
std::vector<std::string> WordsFor(const OptionKind& option, const std::string& value) {
  if (std::holds_alternative<Flag>(option.value)) return {};
  if (MostArguments(option) == 1) return {value};
  return SplitWords(value);
}

}  // namespace

std::vector<ShownOption> OptionsOfPanels(const ViewerOptions& options) {
  std::vector<ShownOption> shown;
  for (const OptionKind& option : OptionTable(Program::rayview))
    if (IsInPanels(option))
      shown.push_back({option.name, option.topic, option.help, options.Show(option), Range(option), Choices(option),
                       std::holds_alternative<Flag>(option.value)});
  return shown;
}

ViewerOptions WithOption(const Scene& scene, const ViewerOptions& options, const std::string& name,
                         const std::string& value) {
  std::vector<std::string> words{options.files.scene};
  const auto add = [&](const std::vector<std::string>& more) { words.insert(words.end(), more.begin(), more.end()); };
  for (const OptionKind& option : OptionTable(Program::rayview)) {
    if (!IsSetting(option)) continue;
    const bool is_default = options.default_image.has_its_samples && option.name == std::string_view("samples");
    if (name != option.name) {
      if (!is_default) add(options.TypedFor(Program::rayview, option));
    } else if (!value.empty()) {
      // A value that looks like an option needs "=".
      const std::vector<std::string> behind = WordsFor(option, value);
      if (behind.size() == 1)
        add({"-" + name + "=" + behind[0]});
      else
        add({"-" + name}), add(behind);
    }
  }
  ViewerOptions changed = ReadCommandLine<ViewerOptions>(Program::rayview, words);
  CompleteImage(scene, changed);
  CompleteForScene(changed);
  CheckMachine(changed.render, changed.accelerator);
  return changed;
}

}  // namespace ray
