#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/view/panels/Panels.h"

namespace ray {

// The user's panel settings, in a file of at most three lines:
//     theme light
//     letters 1.25
//     width 400

/// Returns $XDG_CONFIG_HOME/raypro/rayview, by default below ~/.config; empty if the user has no folder. Relative names
/// are ignored, as required by the XDG Base Directory Specification.
std::string PanelHabitsFile();

/// Parses the text; std::nullopt if it is invalid. Missing settings have their defaults.
std::optional<PanelSettings> ReadPanelHabits(const std::string& text);

/// Loads the settings from the file; the defaults if it is missing, and with a message if it cannot be parsed.
PanelSettings LoadPanelHabits(const std::string& file);

/// Saves the settings, creating the folder if necessary. Failures are reported and otherwise harmless.
void SavePanelHabits(const std::string& file, const PanelSettings& look);

/// Returns "~/.config/raypro/recent", or below $XDG_CONFIG_HOME; empty if neither exists.
std::string RecentScenesFile();

/// The most recently opened scenes, stored in a file, one absolute path per line, the latest first.
class RecentScenes {
 public:
  static constexpr std::size_t most = 20;

  /// Reads the file; a missing or invalid one counts as empty. With an empty name, nothing is read or written.
  explicit RecentScenes(std::string file);

  void Add(const std::string& scene);
  const std::vector<std::string>& Files() const { return files_; }
  /// Saves the list. A failure is only a message on standard error, since just a convenience is lost.
  void Save() const;

 private:
  std::string file_;
  std::vector<std::string> files_;
  bool has_changed_ = false;
};

}  // namespace ray
