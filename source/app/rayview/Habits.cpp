#include "source/app/rayview/Habits.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

#include "source/app/files/OutputFile.h"
#include "source/app/report/Messages.h"
#include "source/text/Number.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

std::filesystem::path FolderIn(const char* variable) {
  const char* value = std::getenv(variable);
  const std::filesystem::path folder = value ? value : "";
  return folder.is_absolute() ? folder : std::filesystem::path();
}

/// Applies a line; returns false if it is unknown.
bool TakeLine(const std::string& name, const std::string& value, PanelSettings& look) {
  if (name == "theme" && (value == "dark" || value == "light")) {
    look.theme = value == "light" ? PanelTheme::light : PanelTheme::dark;
    return true;
  }
  const auto number = ParseNumber(value);
  if (number.problem) return false;
  if (name == "letters" && number.value >= smallest_letters && number.value <= largest_letters) {
    look.letters = number.value;
    return true;
  }
  if (name == "width" && number.value >= 0) {
    look.width = number.value;
    return true;
  }
  return false;
}

}  // namespace

std::string PanelHabitsFile() {
  std::filesystem::path folder = FolderIn("XDG_CONFIG_HOME");
  if (folder.empty() && !FolderIn("HOME").empty()) folder = FolderIn("HOME") / ".config";
  return folder.empty() ? "" : (folder / "raypro" / "rayview").string();
}

std::optional<PanelSettings> ReadPanelHabits(const std::string& text) {
  PanelSettings look;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name, value, more;
    words >> name >> value;
    if (words >> more || !TakeLine(name, value, look)) return {};
  }
  return look;
}

PanelSettings LoadPanelHabits(const std::string& file) {
  std::error_code error;
  if (file.empty() || !std::filesystem::exists(file, error)) return {};
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const auto look = std::filesystem::is_regular_file(file, error) && in ? ReadPanelHabits(text) : std::nullopt;
  if (!look) PrintError("rayview: " + file + " cannot be parsed; using the default panel layout");
  return look.value_or(PanelSettings());
}

void SavePanelHabits(const std::string& file, const PanelSettings& look) {
  const std::string text = "theme " + std::string(look.theme == PanelTheme::light ? "light" : "dark") + "\nletters " +
                           ToText(look.letters) + "\nwidth " + ToText(look.width) + "\n";
  try {
    std::filesystem::create_directories(std::filesystem::path(file).parent_path());
    WriteWhole(CheckOutput(file, {}), {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  } catch (const std::exception& problem) {
    PrintError("rayview: cannot save the panel layout: " + std::string(problem.what()));
  }
}

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
