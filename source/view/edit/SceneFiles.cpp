#include "source/view/edit/SceneFiles.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "source/parse/Format.h"

namespace ray {
namespace fs = std::filesystem;

std::optional<std::string> ReadSceneFile(const std::string& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in) return {};
  return bytes;
}

std::string FreeCopyName(const std::string& file) {
  const fs::path path(file);
  for (int i = 2;; ++i) {
    const std::string name = path.stem().string() + "-" + std::to_string(i) + path.extension().string();
    fs::path copy = path.parent_path() / name;
    std::error_code error;
    if (!fs::exists(fs::symlink_status(copy, error))) return copy.string();
  }
}

std::vector<std::string> ScenesBeside(const std::string& file) {
  constexpr std::size_t most = 1000;
  const fs::path folder = fs::path(file).parent_path();
  std::vector<std::string> scenes;
  std::error_code error;
  fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error);
  for (; !error && entry != fs::directory_iterator() && scenes.size() < most; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (IsSceneName(name) && fs::is_regular_file(entry->path(), ignored)) scenes.push_back((folder / name).string());
  }
  std::ranges::sort(scenes);
  return scenes;
}

std::string NeighborOf(const std::string& file, const std::vector<std::string>& scenes, int by) {
  const auto count = static_cast<int>(scenes.size());
  const auto found = std::ranges::find(scenes, file);
  if (count == 0 || (found != scenes.end() && count == 1)) return {};
  if (found == scenes.end()) return by > 0 ? scenes.front() : scenes.back();
  const int next = (static_cast<int>(found - scenes.begin()) + by) % count;
  return scenes[static_cast<std::size_t>(next < 0 ? next + count : next)];
}

}  // namespace ray
