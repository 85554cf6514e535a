#include "source/integrate/debug/Heat.h"

#include <gtest/gtest.h>

#include "tests/Project.h"

namespace ray {
namespace {

TEST(Heat, GoesFromBlackToWhiteByPowersOfTen) {
  EXPECT_EQ(HeatColor(0), (R2::Color{0, 0, 0}));
  EXPECT_EQ(HeatColor(1), (R2::Color{0, 0, 0}));
  EXPECT_EQ(HeatColor(10), (R2::Color{0, 0, 1}));
  EXPECT_EQ(HeatColor(100), (R2::Color{1, 0, 0}));
  EXPECT_EQ(HeatColor(1000), (R2::Color{1, 1, 0}));
  EXPECT_EQ(HeatColor(1e4), (R2::Color{1, 1, 1}));
  EXPECT_EQ(HeatColor(1e9), (R2::Color{1, 1, 1}));
}

TEST(Heat, AddsVisitsAndTests) { EXPECT_EQ(Heat({.node_visits = 3, .box_tests = 2, .primitive_tests = 4}), 7); }

// The solids around a camera are found once by each thread.
TEST(Heat, DoesNotDependOnThreadsEvenInsideGlass) {
  const project::Stage stage(project::FromText(
      "camera 0 0 0  0 0 -1  0 1 0  0.5  0.01 100  material 0 0 0 .5 .5 .5 0 0 0 .5 .5 .5 0 0 0 10 1.5 0 "
      "sphere 0 0 0 0 2 sphere 0 0.5 0 -4 1 "));
  RenderSettings settings;
  settings.mode = RenderMode::heat;
  settings.width = settings.height = 32;
  settings.threads = 1;
  const R2::Image one = project::Render(stage, settings, {"none"}).image;
  settings.threads = 4, settings.tile_size = 8;
  EXPECT_TRUE(project::Render(stage, settings, {"none"}).image == one);
}

TEST(HeatColor, IsMappedBackToItsCost) {
  for (double heat = 1; heat <= 10'000; heat *= 1.07) EXPECT_NEAR(HeatOf(HeatColor(heat)) / heat, 1, 1e-12) << heat;
  EXPECT_EQ(HeatOf({0, 0, 2}), 10) << "no color of the scale: the nearest";
}

}  // namespace
}  // namespace ray
