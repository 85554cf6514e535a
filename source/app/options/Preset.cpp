#include "source/app/options/Preset.h"

#include <algorithm>

#include "source/app/options/OptionTable.h"

namespace ray {

std::span<const Preset> Presets() {
  static const std::vector<Preset> table{
      {"draft", "a first look", {{"samples", "4"}, {"max_depth", "2"}, {"shadow_samples", "1"}}},
      {"preview", "visible but unobtrusive noise", {{"error", "4"}, {"shadow_samples", "1"}}},
      {"final", "barely visible noise", {{"error", "1"}, {"shadow_samples", "1"}, {"max_depth", "6"}}},
      {"reference",
       "to compare others with; no ray cut off",
       {{"error", "0.25"}, {"shadow_samples", "1"}, {"max_depth", "100"}, {"min_luminance", "0"}}},
  };
  return table;
}

std::vector<std::string> PresetNames() {
  std::vector<std::string> names{"custom"};
  for (const Preset& preset : Presets()) names.emplace_back(preset.name);
  return names;
}

void ApplyPreset(Options& options, const std::vector<const OptionKind*>& given) {
  for (const Preset& preset : Presets()) {
    if (preset.name != options.quality) continue;
    for (const auto& [name, value] : preset.settings) {
      const OptionKind* option = FindOption(options.program, name);
      if (std::ranges::find(given, option) == given.end()) Store(*option, std::vector<std::string>{value}, options);
    }
  }
}

}  // namespace ray
