#pragma once

#include "source/app/options/RenderOptions.h"
#include "source/scene/Scene.h"

namespace ray {

/// Returns the problem with a setting in a scene: no scene may make it, or its value is not in its option's range;
/// std::nullopt if there is none. For ParseOptions.
std::optional<SettingProblem> ProblemOf(const SceneSetting& setting);

/// Applies the scene's own settings unless the command line or a preset selected there overrides them. Throws
/// SceneErrors for a setting that no scene may make, or that is not in its option's range.
void ApplySettings(const Scene& scene, RenderOptions& options);
/// Returns the options with these settings.
template <class Own>
Own WithSettingsOf(const Scene& scene, Own options) {
  ApplySettings(scene, options);
  return options;
}

/// Applies the default image, unless the scene or the options choose another one; ApplySettings does.
void CompleteImage(const Scene& scene, RenderOptions& options);

/// Returns "-max_depth 2 (room.scn:12:3)" for each effective setting of the scene.
std::vector<std::string> SettingsInForce(const Scene& scene, const RenderOptions& options);

}  // namespace ray
