#include "source/view/FileWatch.h"

#include <algorithm>
#include <filesystem>

namespace ray {

FileWatch::State FileWatch::Of(const std::string& file) {
  std::error_code error;
  State state;
  state.time = std::filesystem::last_write_time(file, error).time_since_epoch().count();
  if (!error) state.size = std::filesystem::file_size(file, error);
  return error ? State{} : state;
}

void FileWatch::Watch(const std::vector<std::string>& files) {
  files_.clear();
  for (const std::string& file : files) files_.push_back({file, Of(file)});
}

bool FileWatch::HasChanged() {
  constexpr int gone = 2;  // looks
  bool has = false;
  for (Watched& watched : files_) {
    const State now = Of(watched.file);
    if (now == State{}) {
      watched.times_missing = std::min(watched.times_missing + 1, gone + 1);
      has |= watched.times_missing == gone;
      continue;
    }
    has |= now != watched.known || watched.times_missing >= gone;
    watched.known = now;
    watched.times_missing = 0;
  }
  return has;
}

}  // namespace ray
