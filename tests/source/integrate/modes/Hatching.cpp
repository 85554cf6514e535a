// Drawings in ink: dark where little light arrives, by strokes alone.

#include <gtest/gtest.h>

#include <string>

#include "tests/Accelerators.h"
#include "tests/Project.h"

namespace ray {
namespace {

constexpr int side = 120;

RenderSettings Drawing(int samples = 1) {
  RenderSettings settings = project::Sized(side);
  settings.samples = samples;
  settings.mode = RenderMode::hatching;
  return settings;
}

/// Renders a wall of this brightness that fills the image.
std::string Wall(double brightness) {
  const std::string b = std::to_string(brightness);
  return "camera 0 0 9  0 0 -1  0 1 0  .4  1 20 ambient " + b + ' ' + b + ' ' + b +
         " material 1 1 1  0 0 0  0 0 0  0 0 0  0 0 0  1 1 0 dir_light 0 0 0  0 0 -1 box 0  -9 -9 -1  9 9 0";
}

double ShareOfInk(const R2::Image& image) {
  double sum = 0;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) sum += 1 - image.At(x, y).r;
  return sum / (image.Width() * image.Height());
}

TEST(Hatching, HasTheMoreInkTheLessLightArrives) {
  double last = 0;
  for (const double shade : {0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95}) {
    const double ink = ShareOfInk(project::Render(project::Stage(project::FromText(Wall(1 - shade))), Drawing()).image);
    EXPECT_GT(ink, last) << shade;
    EXPECT_NEAR(ink, shade, 0.17) << shade;
    last = ink;
  }
}

TEST(Hatching, LeavesFullyLitAndEmptyPlacesBlank) {
  EXPECT_EQ(ShareOfInk(project::Render(project::Stage(project::FromText(Wall(1))), Drawing()).image), 0);
  const std::string nothing = "camera 0 0 9  0 0 -1  0 1 0  .4  1 20 background 0 0 0";
  EXPECT_EQ(ShareOfInk(project::Render(project::Stage(project::FromText(nothing)), Drawing()).image), 0);
}

TEST(Hatching, IsInkOrPaperInEverySample) {
  const auto image = project::Render(project::Stage(project::Root() / "scenes/toon.scn"), Drawing()).image;
  int inked = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const R2::Color c = image.At(x, y);
      EXPECT_TRUE(c == R2::Color{} || c == (R2::Color{1, 1, 1}));
      inked += c == R2::Color{};
    }
  EXPECT_GT(inked, 500);
}

TEST(Hatching, IsTheSameInCropsWithEveryAccelerator) {
  const project::Stage stage(project::Root() / "scenes/toon.scn");
  RenderSettings settings = Drawing(2);
  const R2::Image whole = project::Render(stage, settings).image;
  settings.crop = PixelRectangle{30, 20, 90, 70};
  for (const AcceleratorKind* kind : AcceleratorKinds()) {
    const R2::Image part = project::Render(stage, settings, {.name = kind->name}).image;
    for (int y = 0; y < 50; ++y)
      for (int x = 0; x < 60; ++x) ASSERT_EQ(part.At(x, y), whole.At(x + 30, y + 20)) << kind->name;
  }
}

}  // namespace
}  // namespace ray
