#pragma once

#include <string>
#include <vector>

namespace ray {

/// "~/.config/raypro/recent", or below $XDG_CONFIG_HOME; empty where there is neither.
std::string RecentScenesFile();

/// The scenes that were opened last, kept in a file, one absolute path per line, the last first.
class RecentScenes {
 public:
  static constexpr std::size_t most = 20;

  /// Reads the file; a missing one is empty, and of one that is no list nothing is taken. Empty: nothing is read or
  /// written.
  explicit RecentScenes(std::string file);

  void Add(const std::string& scene);
  const std::vector<std::string>& Files() const { return files_; }
  /// A failure is a message on standard error: nothing is lost but a convenience.
  void Save() const;

 private:
  std::string file_;
  std::vector<std::string> files_;
  bool has_changed_ = false;
};

}  // namespace ray
