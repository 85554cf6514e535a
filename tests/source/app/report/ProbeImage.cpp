#include "source/app/report/ProbeImage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/render/Render.h"
#include "tests/Project.h"

namespace ray {
namespace {

/// Soft light on a ball and a floor: noise in the penumbra and at edges.
constexpr const char* soft =
    "camera 0 2 6  0 -.3 -1  0 1 0  .5  .1 100\n"
    "area_light 1 1 1  0 4 1  0 -1 0  1  1 0 0\n"
    "material 0 0 0  .8 .8 .8  0 0 0  0 0 0  0 0 0  1 1 0\n"
    "box 0  -4 -.1 -4  4 0 4\nsphere 0  0 .8 0  .8\n";

/// The scene and a structure to trace it with.
struct Subject {
  project::Stage stage{project::FromText(soft)};
  const World& world = stage.world;
  std::unique_ptr<const Accelerator> accelerator = FindAcceleratorKind("bvh")->Make(world, {});
};

RenderSettings Settings(int width, int height) {
  RenderSettings settings;
  settings.width = width, settings.height = height;
  settings.samples = 16;
  settings.trace.shadow_samples = 1;
  return settings;
}

TEST(ProbeImage, SquaresAreDifferentOnesWithinTheCrop) {
  const Subject subject;
  RenderSettings settings = Settings(200, 150);
  settings.crop = PixelRectangle{10, 20, 150, 130};
  const auto probed = ProbeImage(subject.world, *subject.accelerator, settings, 1e9, 9);
  ASSERT_EQ(probed.size(), 9u);
  for (std::size_t i = 0; i < probed.size(); ++i) {
    EXPECT_EQ(Common(probed[i].pixels, *settings.crop), probed[i].pixels);
    EXPECT_GT(probed[i].pixels.Area(), 0);
    for (std::size_t k = 0; k < i; ++k) EXPECT_LE(Common(probed[i].pixels, probed[k].pixels).Area(), 0);
  }
}

TEST(ProbeImage, ProbesAtLeastOneSquareAndSmallImagesOnce) {
  const Subject subject;
  const auto whole = ProbeImage(subject.world, *subject.accelerator, Settings(7, 5), 1e9, 16);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].pixels, (PixelRectangle{0, 0, 7, 5}));
  EXPECT_EQ(ProbeImage(subject.world, *subject.accelerator, Settings(200, 150), 0, 16).size(), 1u);
}

// 3 x 3 squares are all of the image, so that their errors add up to its own.
TEST(ProbeImage, SquaresOfTheWholeImageHaveItsErrorAndLight) {
  const Subject subject;
  RenderSettings settings = Settings(96, 96);
  const auto probed = ProbeImage(subject.world, *subject.accelerator, settings, 1e9, 9);
  ASSERT_EQ(probed.size(), 9u);
  double square = 0, mean = 0;
  for (const ProbedSquare& s : probed) square += s.square / 9, mean += s.mean / 9;
  settings.budget.error = {1e-9, ErrorUnit::display};
  settings.budget.adaptive = Adaptive::off;
  const RenderResult result = Render(subject.world, *subject.accelerator, settings);
  EXPECT_NEAR(mean, MeanOf(result.image), 1e-6);
  EXPECT_NEAR(255 * std::sqrt(square), result.error->estimate, 0.1 * result.error->estimate);
}

TEST(ProbeImage, WhatIsLightIsMeasuredAsLight) {
  const Subject subject;
  RenderSettings settings = Settings(32, 32);
  const double displayed = ProbeImage(subject.world, *subject.accelerator, settings, 0, 1)[0].square;
  settings.budget.error = {3, ErrorUnit::relative};
  const double of_light = ProbeImage(subject.world, *subject.accelerator, settings, 0, 1)[0].square;
  settings.budget.error = {0.01, ErrorUnit::linear};
  EXPECT_EQ(ProbeImage(subject.world, *subject.accelerator, settings, 0, 1)[0].square, of_light);
  EXPECT_GT(displayed, 0);
  EXPECT_GT(of_light, 0);
}

}  // namespace
}  // namespace ray
