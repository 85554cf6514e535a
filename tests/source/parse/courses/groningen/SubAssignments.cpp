// Groningen's sub-assignments: each line of docs/groningen.md has its scene, and each scene its line.

#include <gtest/gtest.h>

#include <set>

#include "source/app/options/CommandLine.h"
#include "source/app/options/SceneSettings.h"
#include "tests/Folder.h"
#include "tests/Project.h"

namespace ray {
namespace {

#ifdef RAYPRO_YAML

std::string Page() { return project::BytesOf(project::Root() / "docs/groningen.md"); }

TEST(GroningensSubAssignments, EachHasASceneThatIsReadAndSeen) {
  const std::string page = Page();
  const std::vector<std::string> words{"a.scn", "b.png"};
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(project::Root() / "scenes/groningen")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".yaml") continue;
    ++scenes;
    EXPECT_NE(page.find("`build/raypro scenes/groningen/" + name + "`"), std::string::npos) << name;
    const ParsedScene parsed = Parse(entry.path(), {});
    EXPECT_TRUE(parsed.warnings.empty()) << name << ": " << testing::PrintToString(parsed.warnings);
    RenderSettings settings =
        WithSettingsOf(parsed.scene, ReadCommandLine(Program::raypro, words)).render;
    EXPECT_EQ(settings.width, 800) << name;
    EXPECT_EQ(settings.height, 800) << name;
    EXPECT_EQ(settings.samples % 4, 0) << name;
    settings.width = settings.height = 32;
    const World world(parsed.scene);
    const R2::Image image = Render(world, *FindAcceleratorKind("auto")->Make(world, {}), settings).image;
    std::set<double> reds;
    for (int y = 0; y < image.Height(); ++y)
      for (int x = 0; x < image.Width(); ++x) reds.insert(image.At(x, y).r);
    EXPECT_GT(reds.size(), 4u) << name;
  }
  EXPECT_GE(scenes, 23);
  int lines = 0;
  for (std::size_t i = 0; (i = page.find("| [ ] ", i)) != std::string::npos; ++i) ++lines;
  EXPECT_EQ(lines, scenes);
}

#else

TEST(GroningensSubAssignments, EachHasASceneThatIsReadAndSeen) { GTEST_SKIP() << "built without yaml-cpp"; }

#endif

}  // namespace
}  // namespace ray
