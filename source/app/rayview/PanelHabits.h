#pragma once

#include <optional>
#include <string>

#include "source/view/panels/Panels.h"

/// How a user likes the panels, kept from one run to the next in a file of three lines at most:
///     theme light
///     letters 1.25
///     width 400
namespace ray {

/// $XDG_CONFIG_HOME/raypro/rayview, by default below ~/.config; empty where the user has no folder. A name that is not
/// absolute counts as none, as the XDG Base Directory Specification has it.
std::string PanelHabitsFile();

/// Nothing when the text cannot be parsed; what it does not name is as usual.
std::optional<PanelSettings> ReadPanelHabits(const std::string& text);

/// The settings in the file; the usual ones where there is none, and with a message where it cannot be parsed.
PanelSettings LoadPanelHabits(const std::string& file);

/// Makes the folder where it is missing. Failures are reported and otherwise harmless.
void SavePanelHabits(const std::string& file, const PanelSettings& look);

}  // namespace ray
