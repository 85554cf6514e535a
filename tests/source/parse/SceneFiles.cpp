#include <gtest/gtest.h>

#include <algorithm>

#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace {

// Writing an image over one of these destroys the scene, and a hash without them treats two scenes as one.
TEST(SceneFiles, NameEveryFileOfTheSceneOnce) {
  const auto folder = project::Root() / "scenes";
  const auto names = [&](const char* scene) {
    std::vector<std::string> files = ray::Parse(folder / scene, {}).scene.files;
    for (std::string& file : files) file = std::filesystem::path(file).filename().string();
    return files;
  };
  EXPECT_EQ(names("include.scn"), (std::vector<std::string>{"include.scn", "lines.scn", "sphere.scn"}));
  EXPECT_EQ(names("hello.scn"), (std::vector<std::string>{"hello.scn", "icosahedron.off", "checker.png"}));
  EXPECT_EQ(names("smooth.scn"), (std::vector<std::string>{"smooth.scn", "knot.obj"}));
}

const std::string named_sky = "environment sky.ppm\nsphere -1 0 0 0 1\n", white = "P3 2 1 255 9 9 9 9 9 9\n";

TEST(SceneFiles, TheUsersEnvironmentReplacesTheScenesUndecodedOne) {
  const ray::Folder folder;
  folder.Write("sky.ppm", "no image");
  ray::ParseOptions options;
  EXPECT_NE(ray::ReportOf(folder, folder.Write("in.scn", named_sky).filename(), options), "");
  const ray::Folder elsewhere;
  options.environment = elsewhere.Write("mine.ppm", white);
  const ray::Scene scene = ray::Parse(folder / "in.scn", options).scene;
  ASSERT_TRUE(scene.environment);
  EXPECT_EQ(scene.environment->File(), options.environment);
  ASSERT_EQ(scene.files.size(), 3u);
  EXPECT_EQ(scene.files[1], folder / "sky.ppm") << "it is the scene's, and not to be overwritten";
}

TEST(SceneFiles, TheUsersEnvironmentCountsTowardsTheTextureLimit) {
  const ray::Folder folder;
  folder.Write("texture.ppm", white);
  const std::string scene = "material 1 1 1 1 1 1 0 0 0 0 0 0 0 0 0 9 1 texture.ppm\nsphere 0 0 0 0 1\n";
  folder.Write("in.scn", scene);
  ray::ParseOptions options;
  options.environment = folder.Write("mine.ppm", white);
  options.max_texture_bytes = 48;  // 12 per texel
  EXPECT_EQ(ray::ReportOf(folder, "in.scn", options), "");
  options.max_texture_bytes = 47;
  const std::string report = ray::ReportOf(folder, "in.scn", options);
  EXPECT_TRUE(ray::Contains(report, "mine.ppm: error: the scene's textures take")) << report;
  EXPECT_TRUE(ray::Contains(report, "-memory sets another limit")) << report;
}

// A texture cut out for the web has colors behind its transparent pixels. A file with two uses is read twice.
TEST(SceneFiles, OdditiesOfAnImageAreReportedOnce) {
  const ray::Folder folder;
  std::filesystem::copy(project::Root() / "tests/R2/samples/palette-alpha.png", folder / "leaf.png");
  const auto scene = folder.Write("in.scn",
                                  "material 1 1 1 1 1 1 0 0 0 0 0 0 0 0 0 1 1 leaf.png\nnormal_map 0 leaf.png\n"
                                  "sphere 0 0 0 0 1\n");
  const std::vector<std::string> warnings = ray::Parse(scene, {}).warnings;
  const auto is_of_leaf = [&](const std::string& warning) {
    return warning == (folder / "leaf.png").string() +
                          ": warning: PNG has transparent pixels: alpha is ignored, their colors count in full";
  };
  EXPECT_EQ(std::ranges::count_if(warnings, is_of_leaf), 1) << (warnings.empty() ? "" : warnings[0]);
}

}  // namespace
