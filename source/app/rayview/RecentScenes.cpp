#include "source/app/rayview/RecentScenes.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "source/app/files/OutputFile.h"
#include "source/app/rayview/PanelHabits.h"
#include "source/app/report/Messages.h"

namespace ray {

std::string RecentScenesFile() {
  const std::string habits = PanelHabitsFile();
  return habits.empty() ? "" : (std::filesystem::path(habits).parent_path() / "recent").string();
}

RecentScenes::RecentScenes(std::string file) : file_(std::move(file)) {
  std::error_code error;
  if (file_.empty() || !std::filesystem::is_regular_file(file_, error)) return;
  std::ifstream in(file_, std::ios::binary);
  for (std::string line; files_.size() < most && std::getline(in, line);)
    if (std::filesystem::path(line).is_absolute()) files_.push_back(line);
}

void RecentScenes::Add(const std::string& scene) {
  std::error_code error;
  const std::string path = std::filesystem::absolute(scene, error).lexically_normal().string();
  if (error || !std::filesystem::is_regular_file(path, error)) return;
  if (path.find('\n') != std::string::npos || (!files_.empty() && files_.front() == path)) return;
  std::erase(files_, path);
  files_.insert(files_.begin(), path);
  if (files_.size() > most) files_.pop_back();
  has_changed_ = true;
}

void RecentScenes::Save() const {
  if (file_.empty() || !has_changed_) return;
  std::string text;
  for (const std::string& file : files_) text += file + "\n";
  try {
    std::filesystem::create_directories(std::filesystem::path(file_).parent_path());
    WriteWhole(CheckOutput(file_, {}), {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  } catch (const std::exception& problem) {
    PrintError("rayview: cannot save the list of recent scenes: " + std::string(problem.what()));
  }
}

}  // namespace ray
