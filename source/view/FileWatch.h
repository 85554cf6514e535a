#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ray {

/// Detects that files were written, by polling their times and sizes; no thread.
class FileWatch {
 public:
  void Watch(const std::vector<std::string>& files);
  /// Whether one has changed since the last time this said so. One that is missing has not: editors save by renaming.
  bool HasChanged();

 private:
  struct State {
    std::int64_t time = 0;  // of the last write, in the file system's own unit
    std::uintmax_t size = 0;
    friend bool operator==(const State&, const State&) = default;
  };
  static State Of(const std::string& file);

  std::vector<std::pair<std::string, State>> files_;
};

}  // namespace ray
