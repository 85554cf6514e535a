#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ray {

/// Detects that files were written or removed, by polling their times and sizes; no thread.
class FileWatch {
 public:
  void Watch(const std::vector<std::string>& files);
  /// Returns true if one has changed since this last returned true. A file that is missing has changed only once it is
  /// missing for the second time in a row, since editors save by renaming; one that is there again has changed too.
  bool HasChanged();

 private:
  struct State {
    std::int64_t time = 0;  // of the last write, in the file system's own unit
    std::uintmax_t size = 0;
    friend bool operator==(const State&, const State&) = default;
  };
  struct Watched {
    std::string file;
    State known;
    int times_missing = 0;  // in a row
  };
  static State Of(const std::string& file);

  std::vector<Watched> files_;
};

}  // namespace ray
