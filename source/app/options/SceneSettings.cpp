#include "source/app/options/SceneSettings.h"

#include <algorithm>
#include <utility>

#include "source/app/Status.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/Preset.h"
#include "source/app/options/RenderChecks.h"
#include "source/parse/Text.h"
#include "source/text/EnumNames.h"
#include "source/text/Suggestion.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// Returns the options that a scene may set: those that affect the content of its image. The time it takes, and the
/// files that are read and written, are up to the user, since a scene may come from an untrusted source.
std::vector<std::string_view> SettingNames() {
  std::vector<std::string_view> names = OptionsWith(Program::raypro, Fact::in_scenes);
  std::ranges::sort(names);
  return names;
}

/// Returns true if the command line makes the scene's setting irrelevant. Samples on a grid cannot be taken in passes,
/// which budgets need.
bool IsDecided(const RenderOptions& options, const OptionKind& option) {
  return (options.render.budget.IsOpen() && option.facts.Has(Fact::before_budgets)) || options.IsGiven(option.name) ||
         IsSetByPreset(options.quality, option.name);
}

/// Throws UsageError for a value that the option does not accept.
void Apply(const OptionKind& option, const SceneSetting& setting, Options& options) {
  std::vector<std::string> words = SplitWords(setting.value);
  if (std::holds_alternative<Flag>(option.value)) {
    if (setting.value == "off") return;
    if (setting.value != "on" && !setting.value.empty())
      throw UsageError("-" + std::string(option.name) + " must be on or off, got " + Quoted(setting.value));
    words.clear();
  } else if (words.empty()) {
    throw UsageError("-" + std::string(option.name) + " needs a value");
  }
  if (words.size() < FewestArguments(option) || words.size() > MostArguments(option))
    throw UsageError("usage: " + Synopsis(option));
  Store(option, words, options);
}

/// Returns the option of a setting; null if it does not apply to the program, such as the image size in a window.
const OptionKind* OptionOf(const SceneSetting& setting, const Program& program) {
  const OptionKind* option = FindOption(program, setting.option);
  return option && option->facts.Has(Fact::in_scenes) ? option : nullptr;
}

/// Checks settings that were made without a reader's check, such as those of courses.
void CheckSettings(const Scene& scene) {
  std::vector<SceneError> errors;
  for (const SceneSetting& setting : scene.settings)
    if (auto problem = ProblemOf(setting))
      errors.push_back(ErrorIn(setting.origin, std::move(problem->message), std::move(problem->hint)));
  if (!errors.empty()) throw SceneErrors(std::move(errors));
}

/// Returns the last setting of each name, in the order of the scene.
std::vector<const SceneSetting*> WithoutRepetitions(const std::vector<SceneSetting>& settings) {
  std::vector<const SceneSetting*> last;
  for (const SceneSetting& setting : settings) {
    std::erase_if(last, [&](const SceneSetting* earlier) { return earlier->option == setting.option; });
    last.push_back(&setting);
  }
  return last;
}

/// Returns the settings that the command line leaves to the scene, with their options.
std::vector<std::pair<const OptionKind*, const SceneSetting*>> InForce(const Scene& scene,
                                                                       const RenderOptions& options) {
  std::vector<std::pair<const OptionKind*, const SceneSetting*>> all;
  for (const SceneSetting* setting : WithoutRepetitions(scene.settings)) {
    const OptionKind* option = OptionOf(*setting, *options.program);
    if (option && !IsDecided(options, *option)) all.emplace_back(option, setting);
  }
  return all;
}

/// Returns true if a message names the option: "-focus", but not "-focus_distance".
bool Names(const std::string& message, const std::string& option) {
  const auto is_of_word = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
  const std::string word = "-" + option;
  for (std::size_t i = message.find(word); i != std::string::npos; i = message.find(word, i + 1))
    if (i + word.size() == message.size() || !is_of_word(message[i + word.size()])) return true;
  return false;
}

void CheckLens(const Camera& camera, const RenderOptions& options) {
  if (options.render.camera.HasLens() && !camera.kind->has_lens)
    throw UsageError("-aperture has no effect with -projection " + std::string(camera.kind->name) +
                     ", which has no lens");
}

void CheckFlare(const Camera& camera, const RenderOptions& options) {
  if (options.render.flare > 0 && !camera.IsPinhole())
    throw UsageError("-flare has no effect with -projection " + std::string(camera.kind->name) +
                     "; only a pinhole camera's image has lens flares");
  if (std::ranges::find(options.files.layers, Layer::flare) == options.files.layers.end()) return;
  if (!(options.render.flare > 0)) throw UsageError("-layers flare needs -flare above 0");
  if (!ShowsLight(options.render.mode))
    throw UsageError(std::string("-layers flare has no effect with -mode ") + NameOf(options.render.mode) +
                     ", which has no lens flares");
}

/// Reports settings that contradict each other. If the scene makes all of them, it is the scene's mistake, reported at
/// the first; otherwise it is the user's, who may not know the scene's settings.
[[noreturn]] void Blame(const UsageError& error, const Scene& scene, const RenderOptions& asked) {
  const std::string message = error.what();
  for (const auto& [option, setting] : InForce(scene, asked)) {
    if (!Names(message, option->name)) continue;
    const bool is_of_both =
        std::ranges::any_of(asked.given, [&](const std::string& given) { return Names(message, given); });
    if (!is_of_both) throw SceneErrors({ErrorIn(setting->origin, message)});
    throw UsageError(message + "; -" + option->name + " is set by " + Escaped(setting->origin));
  }
  throw error;
}

}  // namespace

void CompleteImage(const Scene& scene, RenderOptions& options) {
  const auto sets = [&](const char* name) {
    return std::ranges::any_of(scene.settings, [&](const SceneSetting& setting) { return setting.option == name; });
  };
  const auto is_chosen = [&](const char* name) { return options.IsGiven(name) || sets(name); };
  const bool has_size = is_chosen("width") || is_chosen("height");
  RenderSettings& render = options.render;
  DefaultImage& image = options.default_image;
  image.has_its_samples =
      !(is_chosen("samples") || IsSetByPreset(options.quality, "samples") || !options.files.replay.empty());
  if (options.as_course) return;
  if (!has_size) render.width = render.height = image.side;
  if (image.has_its_samples && !render.budget.IsOpen())
    render.samples = has_size ? image.samples_of_a_chosen_size : image.samples;
}

std::optional<SettingProblem> ProblemOf(const SceneSetting& setting) {
  const OptionKind* option = OptionOf(setting, Program::raypro);
  if (!option)
    return SettingProblem{"a scene cannot set " + Quoted(setting.option),
                          Suggestion(setting.option, SettingNames(), "settings")};
  try {
    RenderOptions scratch;
    Apply(*option, setting, scratch);
  } catch (const UsageError& error) {
    return SettingProblem{error.what(), {}};
  }
  return {};
}

void ApplySettings(const Scene& scene, RenderOptions& options) {
  CheckSettings(scene);
  for (const auto& [option, setting] : InForce(scene, options)) Apply(*option, *setting, options);
  CompleteImage(scene, options);
  try {
    CompleteForScene(options);
    CheckLens(scene.camera, options);
    CheckFlare(scene.camera, options);
  } catch (const UsageError& error) {
    Blame(error, scene, options);
  }
}

std::vector<std::string> SettingsInForce(const Scene& scene, const RenderOptions& options) {
  std::vector<std::string> lines;
  for (const auto& [option, setting] : InForce(scene, options))
    lines.push_back("-" + std::string(option->name) + " " + setting->value + " (" + setting->origin + ")");
  return lines;
}

}  // namespace ray
