#pragma once

#include "source/app/options/RenderOptions.h"
#include "source/scene/Scene.h"

namespace ray {

/// Why no scene may make this setting, or that its value is not in its option's range; nothing where all is well. For
/// ParseOptions.
std::optional<SettingProblem> ProblemOf(const SceneSetting& setting);

/// Puts the scene's own settings in force where neither the command line nor a preset that it asked for says otherwise.
/// Throws SceneErrors for a setting that no scene may make, or that is not in its option's range.
void ApplySettings(const Scene& scene, RenderOptions& options);
/// The options with these settings.
template <class Own>
Own WithSettingsOf(const Scene& scene, Own options) {
  ApplySettings(scene, options);
  return options;
}

/// "-max_depth 2 (room.scn:12:3)" for each setting of the scene that is in force.
std::vector<std::string> SettingsInForce(const Scene& scene, const RenderOptions& options);

}  // namespace ray
