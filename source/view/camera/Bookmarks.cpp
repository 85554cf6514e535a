#include "source/view/camera/Bookmarks.h"

#include <filesystem>
#include <fstream>

#include "source/scene/CameraText.h"

namespace ray {

Bookmarks::Bookmarks(const std::string& scene) : file_(scene + ".views") {
  std::ifstream in(file_);
  for (std::string line; std::getline(in, line);) {
    if (line.size() < 2 || line[0] < '1' || line[0] > '9' || line[1] != ' ') continue;
    if (const auto camera = ReadCameraLine(line.substr(2))) cameras_.insert_or_assign(line[0] - '0', *camera);
  }
}

std::optional<Camera> Bookmarks::Find(int digit) const {
  const auto found = cameras_.find(digit);
  return found == cameras_.end() ? std::nullopt : std::optional(found->second);
}

bool Bookmarks::Keep(int digit, const Camera& camera) {
  cameras_.insert_or_assign(digit, camera);
  const std::string fresh = file_ + ".new";
  {
    std::ofstream out(fresh);
    for (const auto& [number, kept] : cameras_) out << number << " " << CameraLine(kept) << "\n";
    if (!out.flush()) return false;
  }
  std::error_code error;
  std::filesystem::rename(fresh, file_, error);
  return !error;
}

}  // namespace ray
