// A scene of any course gives the same image, bit for bit, with every accelerator, number of threads and tile size.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "source/app/options/CommandLine.h"
#include "source/app/options/SceneSettings.h"
#include "source/parse/SceneError.h"
#include "tests/Project.h"

namespace {

using Paths = std::vector<std::filesystem::path>;

/// Returns files in a folder that the readers of other courses recognize by their extension; empty if the folder is
/// missing.
Paths CourseScenesBelow(const std::filesystem::path& folder) {
  const std::set<std::string> extensions{".yaml", ".yml", ".json", ".txt"};
  Paths found;
  std::error_code absent;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, absent))
    if (extensions.contains(entry.path().extension())) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

/// Returns the settings of the scene for a small image.
ray::RenderSettings Small(const ray::Scene& scene) {
  ray::RenderOptions asked = ray::ReadCommandLine(
      ray::Program::raypro, std::vector<std::string>{"a.scn", "b.pfm", "-width", "40", "-height", "30"});
  ray::RenderSettings settings = WithSettingsOf(scene, asked).render;
  settings.threads = 1;
  return settings;
}

void ExpectTheSameImage(const project::Stage& stage, const std::string& name) {
  const ray::RenderSettings usual = Small(*stage.scene);
  const auto bits = [&](const ray::RenderSettings& settings, const char* accelerator) {
    ray::AcceleratorSettings how;
    how.name = accelerator;
    return project::Render(stage, settings, how).image.Channels();
  };
  const auto wanted = bits(usual, "bvh");
  for (const char* accelerator : {"graph", "grid", "octree", "auto"})
    EXPECT_TRUE(bits(usual, accelerator) == wanted) << name << ' ' << accelerator;
  if (stage.world.Primitives() < 1000) {
    EXPECT_TRUE(bits(usual, "none") == wanted) << name << " none";
  }
  ray::RenderSettings spread = usual;
  spread.threads = 3;
  spread.tile_size = 8;
  EXPECT_TRUE(bits(spread, "bvh") == wanted) << name << " in tiles";
}

/// Skips files that are not scenes, or lack the files that they name.
int CheckAll(const Paths& files) {
  int scenes = 0;
  for (const auto& file : files) {
    try {
      ray::ParseOptions options;
      options.allowed_folders = {file.parent_path().parent_path().string()};
      ray::Scene scene = ray::Parse(file.string(), options).scene;
      ++scenes;
      ExpectTheSameImage(project::Stage(std::move(scene)), file.string());
    } catch (const ray::SceneErrors&) {
    }
  }
  return scenes;
}

TEST(CourseScenes, OursAreBitIdenticalForAnyAcceleratorThreadsAndTiles) {
  EXPECT_GE(CheckAll(CourseScenesBelow(project::Root() / "scenes")), 15);
}

TEST(CourseScenes, TheirsAreBitIdenticalForAnyAcceleratorThreadsAndTiles) {
  if (!std::filesystem::exists(project::Shared() / "scenes-cs315")) GTEST_SKIP() << "needs ../shared";
  EXPECT_GE(CheckAll(CourseScenesBelow(project::Shared() / "scenes-groningen")), 15);
  EXPECT_GE(CheckAll(CourseScenesBelow(project::Shared() / "scenes-cs315")), 9);
  EXPECT_GE(CheckAll(CourseScenesBelow(project::Shared() / "scenes-comp30019")), 3);
}

}  // namespace
