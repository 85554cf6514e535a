#include "source/view/camera/Bookmarks.h"

#include <fstream>

#include "source/scene/CameraText.h"

namespace ray {

Bookmarks::Bookmarks(const std::string& scene) : file_(scene.empty() || scene == "-" ? "" : scene + ".views") {
  ReadAgain();
}

void Bookmarks::ReadAgain() {
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

std::string Bookmarks::Text() const {
  std::string text;
  for (const auto& [digit, camera] : cameras_) text += std::to_string(digit) + " " + CameraLine(camera) + "\n";
  return text;
}

}  // namespace ray
