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

bool IsSetByPreset(const Options& options, const std::string& name) {
  for (const Preset& preset : Presets())
    if (preset.name == options.quality)
      return std::ranges::any_of(preset.settings, [&](const auto& setting) { return name == setting.first; });
  return false;
}

void ApplyPreset(Options& options) {
  for (const Preset& preset : Presets()) {
    if (preset.name != options.quality) continue;
    for (const auto& [name, value] : preset.settings)
      if (!options.IsGiven(name)) Store(*FindOption(options.program, name), std::vector<std::string>{value}, options);
  }
}

}  // namespace ray
