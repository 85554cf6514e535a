#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ray {

/// Notices that files were written. Looks at their times and sizes when asked to; no thread.
class FileWatch {
 public:
  void Watch(const std::vector<std::string>& files);
  /// Whether one has changed since the last time this said so. One that is missing has not: editors save by renaming.
  bool HasChanged();

 private:
  struct State {
    std::filesystem::file_time_type time{};
    std::uintmax_t size = 0;
    friend bool operator==(const State&, const State&) = default;
  };
  static State Of(const std::string& file);

  std::vector<std::pair<std::string, State>> files_;
};

}  // namespace ray
