#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/parse/Parse.h"
#include "source/render/Render.h"
#include "tests/Folder.h"

/// Scenes of the project and their images.
namespace project {

/// All .scn files directly in a folder, in order of name.
inline std::vector<std::filesystem::path> Scenes(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".scn") scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

/// A scene ready to be traced.
struct Stage {
  explicit Stage(const std::filesystem::path& file) : Stage(ray::Parse(file, {}).scene) {}
  explicit Stage(ray::Scene s) : scene(std::make_unique<ray::Scene>(std::move(s))), world(*scene) {}

  std::unique_ptr<ray::Scene> scene;
  ray::World world;
};

/// Returns default settings for an image of this size, which is square unless a height is given.
inline ray::RenderSettings Sized(int width, std::optional<int> height = {}) {
  ray::RenderSettings settings;
  settings.width = width;
  settings.height = height.value_or(width);
  return settings;
}

inline ray::RenderResult Render(const Stage& stage, const ray::RenderSettings& settings,
                                const ray::AcceleratorSettings& how = {}) {
  const auto accelerator = ray::FindAcceleratorKind(how.name)->Make(stage.world, how);
  return ray::Render(stage.world, *accelerator, settings);
}

/// A scene written in place, read as if it lay in scenes/. Nothing of it stays where the text is refused or an
/// allocation fails.
inline ray::Scene FromText(const std::string& text) {
  struct Files {
    std::string folder, scene;
    ~Files() {  // allocates nothing
      std::remove(scene.c_str());
      std::remove(folder.c_str());
    }
  } files{(std::filesystem::temp_directory_path() / "raypro-test-XXXXXX").string(), {}};
  files.scene = files.folder + "/scene.scn";
  mkdtemp(files.folder.data());
  files.folder.copy(files.scene.data(), files.folder.size());
  if (FILE* out = std::fopen(files.scene.c_str(), "wb")) {
    std::fwrite(text.data(), 1, text.size(), out);
    std::fclose(out);
  }
  return ray::Parse(files.scene, {}).scene;
}

}  // namespace project
