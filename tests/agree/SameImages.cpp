// The same image, bit for bit, for any accelerator with its switches, threads, tiles and crops.

#include <gtest/gtest.h>

#include "source/integrate/debug/Heat.h"
#include "tests/Accelerators.h"
#include "tests/Project.h"

namespace {

ray::RenderSettings Small() {
  ray::RenderSettings settings = project::Sized(24, 18);
  settings.samples = 2;
  settings.trace.shadow_samples = 3;
  return settings;
}

std::vector<accelerators::Way> EveryWayAndSwitch() {
  auto ways = accelerators::EveryWay();
  for (int switches = 1; switches < 8; ++switches)
    ways.push_back({"graph, switches " + std::to_string(switches),
                    {"graph", (switches & 1) == 0, (switches & 2) == 0, (switches & 4) == 0}});
  return ways;
}

TEST(Extremes, C7_J2_J4_EveryAcceleratorInstructionSetAndSwitchGivesTheSameBits) {
  for (const auto& file : project::Scenes(project::Root() / "scenes")) {
    const project::Stage stage(file);
    const auto expected = project::Render(stage, Small(), {"none"});
    for (const auto& [name, how] : EveryWayAndSwitch())
      EXPECT_TRUE(project::Render(stage, Small(), how).image == expected.image) << file << " by " << name;
  }
}

TEST(Extremes, J1_ThreadsAndTilesNeverChangeABit) {
  int scenes = 0;
  for (const auto& file : project::Scenes(project::Root() / "scenes")) {
    const project::Stage stage(file);
    ray::RenderSettings settings = Small();
    settings.threads = 1;
    const auto expected = project::Render(stage, settings, {"none"});
    const auto kinds = ray::AcceleratorKinds();
    std::size_t turn = 0;
    ++scenes;
    for (const int threads : {1, 3, 16})
      for (const int tile : {1, 8, 64, 0}) {
        settings.threads = threads;
        settings.tile_size = tile;
        const char* kind = kinds[turn++ % kinds.size()]->name;
        EXPECT_TRUE(project::Render(stage, settings, {kind}).image == expected.image)
            << file << " on " << threads << " threads in tiles of " << tile << " by " << kind;
      }
  }
  EXPECT_GE(scenes, 20);
}

TEST(SameImages, CountsDependOnTheTilesButNotOnTheThreads) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  ray::RenderSettings settings = Small();
  settings.tile_size = 8;
  settings.threads = 1;
  const auto one = project::Render(stage, settings);
  settings.threads = 7;
  const auto seven = project::Render(stage, settings);
  EXPECT_EQ(one.rays, seven.rays);
}

TEST(SameImages, OfHeatDependOnTheAcceleratorAndOnNothingElse) {
  const project::Stage stage(project::Root() / "scenes" / "smooth.scn");
  ray::RenderSettings settings = Small();
  settings.mode = ray::RenderMode::heat;
  settings.threads = 1;
  const auto bvh = project::Render(stage, settings, {"bvh"});
  settings.threads = 3;
  settings.tile_size = 8;
  EXPECT_TRUE(project::Render(stage, settings, {"bvh"}).image == bvh.image);
  EXPECT_FALSE(project::Render(stage, settings, {"none"}).image == bvh.image);
}

TEST(SameImages, OfRayCountsAreRightForEveryAccelerator) {
  // One light without size: a pixel of the sphere takes its own ray and a shadow ray, one next to it only its own.
  const project::Stage stage(
      project::FromText("camera 0 0 5  0 0 -1  0 1 0  0.3  0.01 100\npoint_light 1 1 1  0 0 5  1 0 0\n"
                        "material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  1 1 0\nsphere 0  0 0 0  1\n"));
  ray::RenderSettings settings = project::Sized(9);
  settings.mode = ray::RenderMode::rays;
  const auto image = project::Render(stage, settings, {"bvh"}).image;
  EXPECT_NEAR(image.At(4, 4).b, ray::HeatColor(2).b, 1e-6);
  EXPECT_EQ(image.At(0, 0), ray::HeatColor(1));
  EXPECT_EQ(project::Render(stage, settings, {"none"}).image, image);
}

TEST(SameImages, ACropHasThePixelsOfTheWhole) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  ray::RenderSettings settings = Small();
  const auto whole = project::Render(stage, settings);
  const ray::PixelRectangle crops[] = {{0, 0, 1, 1}, {23, 17, 24, 18}, {5, 3, 17, 12}, {0, 0, 24, 18}};
  for (const auto& crop : crops) {
    settings.crop = crop;
    const auto part = project::Render(stage, settings);
    ASSERT_EQ(part.image.Width(), crop.x1 - crop.x0);
    ASSERT_EQ(part.image.Height(), crop.y1 - crop.y0);
    for (int y = crop.y0; y < crop.y1; ++y)
      for (int x = crop.x0; x < crop.x1; ++x)
        EXPECT_EQ(part.image.At(x - crop.x0, y - crop.y0), whole.image.At(x, y)) << x << ' ' << y;
  }
}

TEST(SameImages, AnotherSeedMovesTheNoiseOfASoftShadow) {
  const project::Stage stage(project::Root() / "scenes" / "area_light.scn");
  ray::RenderSettings settings = Small();
  const auto first = project::Render(stage, settings);
  settings.seed = 1;
  EXPECT_FALSE(project::Render(stage, settings).image == first.image);
}

TEST(SameImages, StoppedBeforeTheFirstPixelAreBlackAndReported) {
  const project::Stage stage(project::Root() / "scenes" / "sphere.scn");
  const auto accelerator = ray::FindAcceleratorKind("none")->Make(stage.world, {});
  const std::atomic<bool> stop = true;
  ray::RenderMonitor monitor;
  monitor.stop = &stop;
  const auto result = ray::Render(stage.world, *accelerator, Small(), monitor);
  EXPECT_FALSE(result.IsComplete());
  EXPECT_EQ(result.pixels_done, 0);
  EXPECT_EQ(result.image, R2::Image(24, 18));
}

TEST(SameImages, ThePublicCourseScenesAgreeToo) {
  if (!std::filesystem::exists(project::Shared() / "scenes-cos426"))
    GTEST_SKIP() << "the public course scenes are not beside this checkout; scenes/ covers the same ground";
  ray::RenderSettings settings = Small();
  settings.samples = 1;
  for (const char* year : {"course-2007-08", "course-2011-12", "course-526"})
    for (const auto& file : project::Scenes(project::Shared() / "scenes-cos426" / year)) {
      const project::Stage stage(file);
      EXPECT_TRUE(project::Render(stage, settings, {"graph"}).image == project::Render(stage, settings, {"none"}).image)
          << file;
    }
}

}  // namespace
