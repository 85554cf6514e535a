#pragma once

#include <span>
#include <string>
#include <vector>

#include "source/app/options/RenderOptions.h"

namespace ray {

/// A named set of settings that trade speed for accuracy. All values are as typed after options.
struct Preset {
  const char* name;
  const char* about;
  std::vector<std::pair<const char*, const char*>> settings;  // option, value
};

/// Returns the presets, from fast to accurate.
std::span<const Preset> Presets();
/// Returns "custom", which sets nothing, and the presets.
std::vector<std::string> PresetNames();

/// Returns true if the preset with that name sets the option.
bool IsSetByPreset(const std::string& preset, const std::string& option);
/// Applies the selected preset, except to options that were given.
void ApplyPreset(RenderOptions& options);

}  // namespace ray
