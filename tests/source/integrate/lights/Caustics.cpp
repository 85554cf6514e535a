#include "source/integrate/lights/Caustics.h"

#include <gtest/gtest.h>

#include "tests/Project.h"

namespace ray {
namespace {

const std::string gray = "material 0 0 0  .5 .5 .5  0 0 0  0 0 0  0 0 0  1 1 0\n",
                  mirror = "material 0 0 0  0 0 0  .8 .8 .8  0 0 0  0 0 0  1 1 0\n",
                  bright_lamp = "material 0 0 0  0 0 0  0 0 0  0 0 0  6 6 6  1 1 0\n",
                  dim_lamp = "material 0 0 0  0 0 0  0 0 0  0 0 0  2 2 2  1 1 0\n";

Caustics Of(const std::string& text, const TraceSettings& settings = {}) {
  return CausticsOf(project::Stage(project::FromText(text)).world, settings);
}

TEST(Caustics, RequireScatteringMirroringAndEmissiveSurfaces) {
  const std::string materials = gray + mirror + bright_lamp;
  const std::string floor = "box 0  -3 -1 -3  3 0 3\n", ball = "sphere 1  0 1 0  1\n", light = "sphere 2  0 4 0  .1\n";
  EXPECT_NEAR(Of(materials + floor + ball + light).most, 6 * 0.5 * 0.8, 1e-12);
  EXPECT_EQ(Of(materials + ball + light).most, 0);
  EXPECT_EQ(Of(materials + floor + light).most, 0);
  EXPECT_EQ(Of(materials + floor + ball).most, 0);
  TraceSettings settings;
  settings.max_depth = 1;
  EXPECT_EQ(Of(materials + floor + ball + light, settings).most, 0) << "the third surface is not reached";
  settings.max_depth = 2;
  settings.glossy = true;
  EXPECT_EQ(Of(materials + floor + ball + light, settings).most, 0) << "light samples find it";
}

TEST(Caustics, OfTheBrightestLightAreCounted) {
  const Caustics caustics =
      Of(gray + mirror + bright_lamp + dim_lamp +
         "box 0  -3 -1 -3  3 0 3\nsphere 1  0 1 0  1\nsphere 2  0 4 0  .1\nsphere 3  2 4 0  .1\n");
  EXPECT_TRUE(caustics.Counts({6, 6, 6}));
  EXPECT_FALSE(caustics.Counts({2, 2, 2}));
  EXPECT_FALSE(Caustics().Counts({6, 6, 6}));
}

/// A floor beneath a light, and next to it a mirror or its replacement.
RenderResult WithBesideIt(const std::string& material, const std::string& lamp_size, int samples) {
  const project::Stage stage(
      project::FromText("camera 0 3 4  0 -.6 -1  0 1 0  .4  .1 100\n" + gray + material + bright_lamp +
                        "box 0  -3 -1 -3  3 0 3\nbox 1  -3 0 -3  3 3 -2.9\nsphere 2  0 4 0  " + lamp_size + "\n"));
  RenderSettings settings = project::Sized(24);
  settings.mode = RenderMode::path;
  settings.samples = samples;
  return project::Render(stage, settings);
}

TEST(Caustics, AreFoundBehindAMirrorOnly) {
  EXPECT_GT(WithBesideIt(mirror, "1", 16).rays.caustics, 50U);
  EXPECT_EQ(WithBesideIt(gray, "1", 16).rays.caustics, 0U);
}

TEST(Caustics, ThatNoPathHasFoundWidenTheInterval) {
  const RenderResult unseen = WithBesideIt(mirror, "1e-4", 4), known = WithBesideIt(gray, "1e-4", 4);
  ASSERT_TRUE(unseen.error && known.error);
  EXPECT_EQ(unseen.rays.caustics, 0U);
  EXPECT_EQ(unseen.unseen.samples, 24 * 24 * 4);
  EXPECT_TRUE(unseen.error->IsMostlyUnseen());
  EXPECT_GT(unseen.error->high, 2 * unseen.error->estimate);
  EXPECT_EQ(known.error->unseen_share, 0);
  const RenderResult found = WithBesideIt(mirror, "1", 4);
  EXPECT_GT(found.rays.caustics, 0U);
  EXPECT_EQ(found.error->unseen_share, 0);
}

}  // namespace
}  // namespace ray
