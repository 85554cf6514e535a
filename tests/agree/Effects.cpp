// The same image, bit for bit, also with all features that use random numbers or read neighboring pixels.

#include <gtest/gtest.h>

#include "tests/Accelerators.h"
#include "tests/Named.h"
#include "tests/Project.h"

namespace {

using ray::PixelRectangle;
using ray::RenderSettings;

R2::Image Sky() {
  R2::Image image(16, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) image.Set(x, y, {0.02 * x, 0.1, 0.05 * y});
  image.Set(11, 6, {20, 18, 15});
  return image;
}

/// Glass, mirrors, gloss, emissive textures: an area light, an emissive ball, an emissive triangle, and a sky.
project::Stage EverythingAtOnce() {
  ray::Scene scene = project::FromText(
      "camera 0 1.5 6  0 -0.2 -1  0 1 0  0.35  0.01 100 ambient 0.1 0.1 0.1 "
      "material 0.2 0.2 0.2  0.5 0.4 0.3  0.3 0.3 0.3  0 0 0  0 0 0  20 1 0 "
      "material 0 0 0  0 0 0  0.1 0.1 0.1  0.9 0.9 0.9  0 0 0  50 1.5 0 absorb 1  0.1 0.4 0.2 "
      "material 0 0 0  0 0 0  0 0 0  0 0 0  4 3 2  10 1 0 "
      "area_light 4 4 8  2 4 2  -1 -4 -2  0.7  0 0 1 sphere_light 1 3 1  -1 1 2  0.3  0 0 1 "
      "point_light 1 1 1  0 3 3  0 0 1 "
      "box 0  -9 -1 -9  9 0 9 sphere 1  0.8 0.7 0  0.7 sphere 0  -1 0.6 -1  0.6 cone 0  1.8 0.5 1  0.4 1 "
      "tri 2  -1.5 2 0  -1 2 0.5  -1.5 2.5 0.5 tri 0  -3 0 -2  3 0 -2  0 3 -3");
  scene.environment = std::make_shared<const ray::Environment>(Sky());
  return project::Stage(std::move(scene));
}

RenderSettings Everything(const char* mode, const char* filter) {
  RenderSettings s = project::Sized(37, 29);
  s.samples = 3;
  s.seed = 5;
  s.mode = project::Named{mode};
  s.filter = project::Named{filter};
  s.camera = {.motion = {0.2, 0.1, -0.3}, .aperture = 0.1, .focus = 5};
  s.trace.max_depth = 5;
  s.trace.glossy = s.trace.fresnel = true;
  s.trace.shadow_samples = 2;
  s.trace.roulette = ray::Roulette::on;
  return s;
}

TEST(Effects, EveryAcceleratorGivesTheSameBitsWithAllFeatures) {
  const project::Stage stage = EverythingAtOnce();
  for (const char* mode : {"path", "whitted"}) {
    const RenderSettings settings = Everything(mode, "mitchell");
    const auto expected = project::Render(stage, settings, {"none"});
    EXPECT_GT(expected.rays[ray::RayKind::transmission].rays, 0u);
    EXPECT_GT(expected.rays[ray::RayKind::reflection].rays, 0u);
    for (const auto& [name, how] : accelerators::EveryWay())
      EXPECT_TRUE(project::Render(stage, settings, how).image == expected.image) << mode << " by " << name;
  }
}

TEST(Extremes, J1_ThreadsAndTilesNeverChangeABitWithAllFeatures) {
  const project::Stage stage = EverythingAtOnce();
  for (const char* mode : {"path", "whitted"})
    for (const char* sampler : ray::sampler_names) {
      RenderSettings settings = Everything(mode, "lanczos");
      settings.trace.sampler = project::Named{sampler};
      settings.threads = 1;
      const auto expected = project::Render(stage, settings);
      for (const int threads : {1, 2, 7})
        for (const int tile : {1, 8, 64, 0}) {
          settings.threads = threads;
          settings.tile_size = tile;
          EXPECT_TRUE(project::Render(stage, settings).image == expected.image)
              << mode << ' ' << sampler << ' ' << threads << " threads, tiles of " << tile;
        }
    }
}

// Decisions by an error use sums of samples, which threads and tiles cannot change.
TEST(Extremes, J1_ThreadsAndTilesDoNotChangeRendersToAnError) {
  const project::Stage stage = EverythingAtOnce();
  RenderSettings settings = Everything("path", "gaussian");
  settings.samples = 1;
  settings.budget.error = ray::ErrorTarget{8, ray::ErrorUnit::display};
  settings.threads = 1;
  const auto expected = project::Render(stage, settings);
  EXPECT_EQ(expected.stop, ray::Stop::error);
  for (const int threads : {2, 7})
    for (const int tile : {8, 0}) {
      settings.threads = threads;
      settings.tile_size = tile;
      const auto again = project::Render(stage, settings);
      EXPECT_TRUE(again.image == expected.image) << threads << " threads, tiles of " << tile;
      EXPECT_EQ(again.block_samples, expected.block_samples);
    }
}

// The first samples of an error's two streams were once sixteen, regardless of the time limit.
TEST(Effects, ATimeLimitPromptlyEndsRendersToAnError) {
  const project::Stage stage = EverythingAtOnce();
  RenderSettings settings = Everything("path", "box");
  settings.samples = 1;
  settings.budget.error = ray::ErrorTarget{1e-6, ray::ErrorUnit::display};
  settings.budget.seconds = 1e-6;
  const auto result = project::Render(stage, settings);
  EXPECT_EQ(result.stop, ray::Stop::time);
  EXPECT_EQ(result.samples.most, 1u);
  EXPECT_LT(result.samples.mean, 0.1);
  EXPECT_GT(result.pixels_done, 0);
  // With enough time, the error decides after as many samples as without a limit.
  settings.budget.error = ray::ErrorTarget{8, ray::ErrorUnit::display};
  settings.budget.seconds = 1e6;
  const auto unhurried = project::Render(stage, settings);
  settings.budget.seconds = 0;
  EXPECT_TRUE(unhurried.image == project::Render(stage, settings).image);
  EXPECT_EQ(unhurried.stop, ray::Stop::error);
}

void ExpectPart(const R2::Image& part, const PixelRectangle& crop, const R2::Image& whole, const std::string& what) {
  ASSERT_EQ(part.Width(), crop.Width()) << what;
  ASSERT_EQ(part.Height(), crop.Height()) << what;
  for (int y = crop.y0; y < crop.y1; ++y)
    for (int x = crop.x0; x < crop.x1; ++x)
      ASSERT_EQ(part.At(x - crop.x0, y - crop.y0), whole.At(x, y)) << what << ' ' << x << ' ' << y;
}

TEST(Extremes, G6_CropsMatchTheWholeUnderEveryFilter) {
  const project::Stage stage = EverythingAtOnce();
  for (const char* filter : ray::filter_names)
    for (const char* mode : {"path", "whitted", "normal"}) {
      RenderSettings settings = Everything(mode, filter);
      const auto whole = project::Render(stage, settings).image;
      for (const PixelRectangle& crop :
           {PixelRectangle{0, 0, 1, 1}, PixelRectangle{36, 28, 37, 29}, PixelRectangle{8, 8, 9, 9},
            PixelRectangle{7, 15, 8, 16}, PixelRectangle{19, 13, 20, 14}, PixelRectangle{5, 3, 30, 20},
            PixelRectangle{0, 0, 37, 29}}) {
        settings.crop = crop;
        ExpectPart(project::Render(stage, settings).image, crop, whole, std::string(filter) + ", " + mode);
      }
    }
}

TEST(Extremes, G6_TheUnionOfTilesIsTheWhole) {
  const project::Stage stage = EverythingAtOnce();
  for (const char* filter : ray::filter_names) {
    RenderSettings settings = Everything("path", filter);
    settings.samples = 2;
    const auto whole = project::Render(stage, settings).image;
    for (int y = 0; y < settings.height; y += 10)
      for (int x = 0; x < settings.width; x += 13) {
        const PixelRectangle crop{x, y, std::min(x + 13, settings.width), std::min(y + 10, settings.height)};
        settings.crop = crop;
        ExpectPart(project::Render(stage, settings).image, crop, whole, filter);
      }
  }
}

// Settings without an effect must not change a bit of the image.
TEST(Effects, WithoutAnEffectTheyChangeNoBit) {
  const auto rendered = [](const std::string& text, const RenderSettings& settings) {
    return project::Render(project::Stage(project::FromText(text)), settings).image;
  };
  const std::string scene =
      "camera 0 1.5 6  0 -0.2 -1  0 1 0  0.35  0.01 100 area_light 4 4 8  2 4 2  -1 -4 -2  0.7  0 0 1 "
      "material 0.2 0.2 0.2  0.5 0.4 0.3  0.3 0.3 0.3  0 0 0  0 0 0  20 1.5 0 box 0  -9 -1 -9  9 0 9 "
      "sphere 0  0.8 0.7 0  0.7 ";
  RenderSettings plain = project::Sized(24);
  plain.samples = 2;
  const auto expected = rendered(scene, plain);
  RenderSettings stated = plain;
  stated.camera = {.motion = {0, 0, 0}, .aperture = 0, .focus = 3};
  stated.trace.fresnel = true;  // nothing is transparent
  stated.trace.strategy = ray::LightStrategy::light;
  EXPECT_TRUE(rendered(scene + "absorb 0  1 1 1 point_light 0 0 0  0 3 3  1 0 0", stated) == expected);
}

// Blocks of similar pixels take one sample; the decision reads whole blocks and their neighbors.
TEST(Extremes, G6_CropsMatchTheWholeWithAdaptiveNeighbors) {
  const project::Stage stage = EverythingAtOnce();
  for (const char* filter : ray::filter_names) {
    RenderSettings settings = Everything("whitted", filter);
    settings.width = 60, settings.height = 50;
    settings.samples = 4;
    settings.budget.adaptive = ray::Adaptive::neighbors;
    const auto whole = project::Render(stage, settings);
    EXPECT_LT(whole.samples.least, whole.samples.most) << filter;
    for (const PixelRectangle& crop :
         {PixelRectangle{0, 0, 1, 1}, PixelRectangle{8, 8, 16, 16}, PixelRectangle{15, 15, 17, 17},
          PixelRectangle{23, 0, 24, 50}, PixelRectangle{5, 30, 30, 47}, PixelRectangle{0, 0, 60, 50}}) {
      settings.crop = crop;
      ExpectPart(project::Render(stage, settings).image, crop, whole.image, filter);
    }
  }
}

// The target and the samples are those of the crop: see docs/accuracy.md.
TEST(Extremes, G6_AnErrorTargetAppliesToTheCropAlone) {
  const project::Stage stage(project::FromText(
      "camera 0 2 6  0 -.3 -1  0 1 0  .5  .1 100 background .2 .3 .4 area_light 1 1 1  0 4 1  0 -1 0  1  1 0 0 "
      "material 0 0 0  .8 .8 .8  0 0 0  0 0 0  0 0 0  1 1 0 box 0  -4 -.1 -4  4 0 4 sphere 0  0 .8 0  .8"));
  RenderSettings settings = project::Sized(48);
  settings.samples = 64;
  settings.trace.shadow_samples = 1;
  settings.budget.error = ray::ErrorTarget{2, ray::ErrorUnit::display};
  const auto whole = project::Render(stage, settings);
  settings.crop = PixelRectangle{0, 44, 48, 48};  // only background
  const auto part = project::Render(stage, settings);
  EXPECT_LT(part.samples.most, whole.samples.least);
  EXPECT_EQ(part.error->estimate, 0);
}

}  // namespace
