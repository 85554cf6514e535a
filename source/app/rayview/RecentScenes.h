#pragma once

#include <string>
#include <vector>

namespace ray {

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
