#include "source/app/options/SceneSettings.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/Preset.h"
#include "source/parse/Text.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

/// What decides how a picture looks. What decides how long it takes, or which files are read and written, is the
/// user's alone: a scene may come from a stranger.
constexpr std::array<std::string_view, 23> of_scenes{
    "aperture", "bytes",   "clamp",   "emissive_solids", "filter",  "focus",     "fresnel",       "glossy",
    "gooch",    "height",  "lens",    "lens_samples",    "lights",  "max_depth", "min_luminance", "mode",
    "motion",   "sampler", "samples", "shadow_samples",  "shadows", "width",     "zbuffer_range"};

bool IsDecided(const Options& options, const std::string& option) {
  // Samples on a grid cannot be had one pass after another, which budgets need.
  const bool is_of_budget = options.render.budget.IsOpen() && (option == "sampler" || option == "samples");
  return is_of_budget || options.IsGiven(option) || IsSetByPreset(options, option);
}

/// Null for what the program has no use for, such as a size of the picture in a window.
const OptionKind* OptionOf(const SceneSetting& setting, Program program) {
  const OptionKind* option = FindOption(program, setting.option);
  if (option && std::ranges::find(of_scenes, option->name) != of_scenes.end()) return option;
  if (std::ranges::find(of_scenes, setting.option) != of_scenes.end()) return nullptr;
  throw SceneErrors({ErrorIn(setting.origin, "a scene cannot set " + Quoted(setting.option),
                             Suggestion(setting.option, of_scenes, "settings"))});
}

std::vector<std::string> WordsOf(const std::string& value) {
  std::istringstream in(value);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

void Apply(const OptionKind& option, const SceneSetting& setting, Options& options) {
  try {
    std::vector<std::string> words = WordsOf(setting.value);
    if (std::holds_alternative<Flag>(option.value)) {
      if (setting.value == "off") return;
      if (setting.value == "on") words.clear();
    }
    if (words.size() < FewestArguments(option) || words.size() > MostArguments(option))
      throw UsageError("usage: " + Synopsis(option));
    Store(option, words, options);
  } catch (const UsageError& error) {
    throw SceneErrors({ErrorIn(setting.origin, "set " + setting.option + " " + setting.value + ": " + error.what())});
  }
}

}  // namespace

Options WithSettingsOf(const Scene& scene, const Options& options) {
  Options all = options;
  for (const SceneSetting& setting : scene.settings) {
    const OptionKind* option = OptionOf(setting, options.program);
    if (option && !IsDecided(options, option->name)) Apply(*option, setting, all);
  }
  CompleteForScene(all);
  return all;
}

std::vector<std::string> SettingsInForce(const Scene& scene, const Options& options) {
  std::vector<std::string> lines;
  for (const SceneSetting& setting : scene.settings) {
    const OptionKind* option = OptionOf(setting, options.program);
    if (option && !IsDecided(options, option->name))
      lines.push_back("-" + std::string(option->name) + " " + setting.value + " (" + setting.origin + ")");
  }
  return lines;
}

}  // namespace ray
