#include "source/view/FileWatch.h"

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
  for (const std::string& file : files) files_.emplace_back(file, Of(file));
}

bool FileWatch::HasChanged() {
  bool has = false;
  for (auto& [file, known] : files_) {
    const State now = Of(file);
    if (now == known || now == State{}) continue;
    known = now;
    has = true;
  }
  return has;
}

}  // namespace ray
