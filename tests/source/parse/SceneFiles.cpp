#include <gtest/gtest.h>

#include <algorithm>

#include "tests/Project.h"

namespace {

// Whoever writes a picture over one of these destroys the scene, and a hash without them calls two scenes one.
TEST(SceneFiles, NameTheSceneItsIncludesItsMeshesAndItsTexturesOnceEach) {
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

}  // namespace
