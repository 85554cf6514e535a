#pragma once

#include <optional>
#include <string>

#include "source/view/panels/Panels.h"

/// The user's panel settings, stored between runs in a file of at most three lines:
///     theme light
///     letters 1.25
///     width 400
namespace ray {

/// Returns $XDG_CONFIG_HOME/raypro/rayview, by default below ~/.config; empty if the user has no folder. Relative names
/// are ignored, as required by the XDG Base Directory Specification.
std::string PanelHabitsFile();

/// Parses the text; std::nullopt if it is invalid. Missing settings have their defaults.
std::optional<PanelSettings> ReadPanelHabits(const std::string& text);

/// Loads the settings from the file; the defaults if it is missing, and with a message if it cannot be parsed.
PanelSettings LoadPanelHabits(const std::string& file);

/// Saves the settings, creating the folder if necessary. Failures are reported and otherwise harmless.
void SavePanelHabits(const std::string& file, const PanelSettings& look);

}  // namespace ray
