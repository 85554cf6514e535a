// Reflections that a material blurs, regardless of the settings.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/Project.h"

namespace ray {
namespace {

/// Black balls that mirror a floor of stripes, one in front of the other; `more` belongs to their material.
std::string MirrorBalls(const std::string& n, const std::string& more) {
  return "camera 0 1 6  0 -.1 -1  0 1 0  .4  .01 100 background .3 .5 .9 point_light 1 1 1  3 6 5  1 0 0 "
         "material 0 0 0  0 0 0  .6 .7 .8  0 0 0  0 0 0  " +
         n + " 1 0 " + more +
         " material 0 0 0  .8 .2 .1  0 0 0  0 0 0  0 0 0  1 1 0 "
         "sphere 0  -.8 .7 0  .7 sphere 0  .9 .7 .5  .7 box 1  -4 -.2 -4  4 0 0 box 1  -4 -.2 1  4 0 3";
}

RenderSettings GlossSettings(int count = 4) {
  RenderSettings settings = project::Sized(40);
  settings.samples = count;
  settings.trace.min_luminance = 0;
  return settings;
}

RenderResult Glossy(const std::string& scene, const RenderSettings& settings) {
  return project::Render(project::Stage(project::FromText(scene)), settings);
}

TEST(Gloss, WithTheHighlightsExponentEqualsTheSettingGlossy) {
  for (const RenderMode mode : {RenderMode::whitted, RenderMode::path}) {
    RenderSettings settings = GlossSettings();
    settings.mode = mode;
    const auto own = Glossy(MirrorBalls("50", "gloss 0 50 1"), settings).image.Channels();
    EXPECT_FALSE(own == Glossy(MirrorBalls("50", ""), settings).image.Channels()) << "a mirror";
    settings.trace.glossy = true;
    EXPECT_TRUE(own == Glossy(MirrorBalls("50", ""), settings).image.Channels());
  }
}

TEST(Gloss, HasAnExponentOfItsOwn) {
  RenderSettings settings = GlossSettings(256);
  settings.trace.shadows = false;
  // Without lights there are no highlights, so n has no effect except with -glossy.
  const auto without_light = [](std::string scene) { return scene.replace(scene.find("1 1 1  3 6 5"), 5, "0 0 0"); };
  const auto own = Glossy(without_light(MirrorBalls("9", "gloss 0 50 1")), settings).image.Channels();
  settings.trace.glossy = true;
  EXPECT_TRUE(own == Glossy(without_light(MirrorBalls("50", "")), settings).image.Channels());
  EXPECT_TRUE(own == Glossy(without_light(MirrorBalls("9", "gloss 0 50 1")), settings).image.Channels())
      << "whatever is set";
}

// All pixels see the same point of a ball, so that they differ by noise alone: with 256 random rays, noise is a
// sixteenth of that of one, and less if they are evenly distributed.
TEST(Gloss, WithManyRaysEqualsManySamples) {
  RenderSettings settings = GlossSettings(1);
  settings.trace.max_depth = 1;
  const auto seen = [&](const std::string& more, int count) {
    settings.samples = count;
    std::string scene = MirrorBalls("20", more);
    scene.replace(scene.find(".4  .01 100"), 2, ".000001");
    scene.replace(scene.find("0 -.1 -1"), 8, "-.133 -.085 -1");
    return Glossy(scene, settings).image;
  };
  const R2::Image shared = seen("gloss 0 20 256", 1), one = seen("gloss 0 20 1", 1), many = seen("gloss 0 20 1", 256);
  R2::Color mean;
  for (int i = 0; i < 1600; ++i) mean += many.At(i % 40, i / 40) / 1600;
  const auto noise = [&](const R2::Image& image) {
    double sum = 0;
    for (int i = 0; i < 1600; ++i) sum += std::pow(Luminance(image.At(i % 40, i / 40) - mean), 2) / 1600;
    return std::sqrt(sum);
  };
  EXPECT_GT(noise(one), 0.02);
  EXPECT_LT(noise(shared), noise(one) / 12);
}

TEST(Gloss, TracesTheStatedNumberOfRays) {
  RenderSettings settings = GlossSettings(1);
  settings.trace.max_depth = 1;
  const auto rays = [&](const std::string& more) {
    return static_cast<double>(Glossy(MirrorBalls("20000", more), settings).rays[RayKind::reflection].rays);
  };
  const double one = rays("gloss 0 1000000 1");
  EXPECT_GT(one, 200);
  EXPECT_NEAR(rays("gloss 0 1000000 7"), 7 * one, 0.01 * 7 * one) << "but for those below the horizon";
}

TEST(Gloss, IsTheSameImageForAnyThreadsAndTiles) {
  RenderSettings settings = GlossSettings();
  settings.threads = 1;
  const auto wanted = Glossy(MirrorBalls("20", "gloss 0 20 5"), settings).image.Channels();
  settings.threads = 3;
  settings.tile_size = 8;
  EXPECT_TRUE(Glossy(MirrorBalls("20", "gloss 0 20 5"), settings).image.Channels() == wanted);
}

}  // namespace
}  // namespace ray
