// Why a pixel differs from a reference: the reference is a render with one thing changed.
#include "source/inspect/PixelExplanation.h"

#include <gtest/gtest.h>

#include "tests/Project.h"

namespace ray {
namespace {

class Explained : public ::testing::Test {
 protected:
  static LoadedScene Scene(const std::string& lights) {
    ParsedScene parsed;
    parsed.scene = project::FromText(
        "camera 0 2 6  0 -0.3 -1  0 1 0  0.4  0.01 100\nambient 0.1 0.1 0.1\nbackground 0.2 0.3 0.4\n" + lights +
        "material 0.5 0.5 0.5  0.4 0.5 0.3  0.3 0.3 0.3  0 0 0  0 0 0  10 1 0\n"
        "box 0  -4 -1 -4  4 -0.9 4\nsphere 0  0 0 0  0.8\n");
    return LoadedScene(std::move(parsed), AcceleratorSettings{});
  }
  static RenderSettings Settings() {
    RenderSettings settings = project::Sized(80, 60);
    settings.trace.max_depth = 3;
    return settings;
  }
  /// What is said of a pixel of the scene whose reference is that of another scene or with other settings.
  static std::string Why(const LoadedScene& ours, const LoadedScene& theirs, const RenderSettings& settings,
                         int column = 40, int row = 30) {
    const PixelTrace pixel = PixelTracer(ours.world, *ours.accelerator, Settings()).Trace(column, row, 1);
    const PixelTrace other = PixelTracer(theirs.world, *theirs.accelerator, settings).Trace(column, row, 1);
    const auto why = ExplainPixel(pixel, other.Mean(), ours, Settings());
    return why ? why->text : "nothing";
  }
};

const std::string one = "point_light 0.5 0.5 0.5  3 5 6  1 0 0\n", other = "dir_light 0.3 0.1 0.2  -1 -1 -1\n";

TEST_F(Explained, IsNothingWhereThePixelIsRight) {
  const LoadedScene scene = Scene(one + other);
  EXPECT_EQ(Why(scene, scene, Settings()), "nothing");
}

TEST_F(Explained, IsALightThatIsMissing) {
  EXPECT_NE(Why(Scene(one + other), Scene(one), Settings()).find("lacks what the"), std::string::npos)
      << Why(Scene(one + other), Scene(one), Settings());
}

TEST_F(Explained, IsABounceOrAShadow) {
  const LoadedScene scene = Scene(one + other);
  RenderSettings fewer = Settings();
  fewer.trace.max_depth = 0;
  EXPECT_NE(Why(scene, scene, fewer).find("lacks what the reflection ray"), std::string::npos)
      << Why(scene, scene, fewer);
  RenderSettings unshadowed = Settings();
  unshadowed.trace.shadows = false;
  int found = 0;
  for (int column = 0; column < 80; ++column)
    for (int row = 0; row < 30; row += 3)
      found += Why(scene, scene, unshadowed, column, row).find("shadow") != std::string::npos;
  EXPECT_GT(found, 5) << "in the shadow of the ball";
}

TEST_F(Explained, IsNothingWhereTheReferenceIsOfAnotherScene) {
  const LoadedScene scene = Scene(one);
  const PixelTrace pixel = PixelTracer(scene.world, *scene.accelerator, Settings()).Trace(40, 30, 1);
  EXPECT_FALSE(ExplainPixel(pixel, {0.9, 0.01, 0.5}, scene, Settings()));
}

}  // namespace
}  // namespace ray
