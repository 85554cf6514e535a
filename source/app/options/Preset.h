#pragma once

#include <span>
#include <string>
#include <vector>

#include "source/app/options/RenderOptions.h"

namespace ray {

/// A named choice of the settings that trade speed for accuracy. All values are as they would be typed behind options.
struct Preset {
  const char* name;
  const char* about;
  std::vector<std::pair<const char*, const char*>> settings;  // option, value
};

/// The presets, from fast to right.
std::span<const Preset> Presets();
/// "custom", which sets nothing, and the presets.
std::vector<std::string> PresetNames();

/// Whether the preset of that name has a value for the option.
bool IsSetByPreset(const std::string& preset, const std::string& option);
/// Applies that preset, except for options that were given.
void ApplyPreset(RenderOptions& options);

}  // namespace ray
