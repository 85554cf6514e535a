#include "source/integrate/shading/Coat.h"

#include <gtest/gtest.h>

#include "source/integrate/shading/Bsdf.h"
#include "tests/Project.h"

namespace ray {
namespace {

constexpr double coat_indices[] = {1, 1.33, 1.5, 2.4, 0.7};

TEST(Coat, MatchesFresnelHeadOnAndMirrorsFullyAtGrazing) {
  for (const double index : coat_indices) {
    EXPECT_NEAR(Coat(index).Reflectance(1), FresnelReflectance(1, 1 / index), 1e-15) << index;
    EXPECT_EQ(Coat(index).Reflectance(0), 1) << index;
  }
}

TEST(Coat, VarnishIsWithinFourHundredthsOfFresnel) {
  for (double cosine = 0.05; cosine <= 1; cosine += 0.05)
    EXPECT_NEAR(Coat(1.5).Reflectance(cosine), FresnelReflectance(cosine, 1 / 1.5), 0.04) << cosine;
}

// By the midpoint rule: the light that a white base scatters, over all directions, and the light that the coat reflects
// sum to 1.
TEST(Coat, AWhiteBaseLosesNothing) {
  for (const double index : coat_indices)
    for (const double out : {0.05, 0.3, 0.7, 1.0}) {
      constexpr int steps = 2000;
      double scattered = 0;
      for (int i = 0; i < steps; ++i) {
        const double in = (i + 0.5) / steps;
        scattered += 2 * in * Coat(index).DiffuseShare(in, out) / steps;  // 2 pi in / pi
      }
      EXPECT_NEAR(scattered + Coat(index).Reflectance(out), 1, 1e-6) << index << " " << out;
    }
}

TEST(Coat, ItIsReciprocal) { EXPECT_NEAR(Coat(1.5).DiffuseShare(0.2, 0.9), Coat(1.5).DiffuseShare(0.9, 0.2), 1e-15); }

Scene CoatedBall(const std::string& kd, const std::string& background) {
  return project::FromText("camera 0 0 4  0 0 -1  0 1 0  0.2  0.1 100\nbackground " + background +
                           "\npoint_light 0 0 0  0 0 9  1 0 0\nmaterial 0 0 0  " + kd +
                           "  0 0 0  0 0 0  0 0 0  1 1 0\ncoat 0 1.5\nsphere 0  0 0 0  1\n");
}

TEST(Coat, AWhiteBallUnderVarnishVanishesInAWhiteFurnace) {
  const project::Stage stage(CoatedBall("1 1 1", "1 1 1"));
  RenderSettings settings = project::Sized(8);
  settings.samples = 256;
  settings.mode = RenderMode::path;
  settings.trace.max_depth = 20;
  const R2::Image image = project::Render(stage, settings).image;
  double sum = 0;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) sum += image.At(x, y).g / 64;
  EXPECT_NEAR(sum, 1, 0.01);
}

TEST(Coat, InModeWhittedItMirrorsAFaintImage) {
  const project::Stage stage(CoatedBall("0 0 0", "1 1 1"));
  RenderSettings settings = project::Sized(1);                                        // straight on
  EXPECT_NEAR(project::Render(stage, settings).image.At(0, 0).r, 0.04, 1e-8);  // an image has single precision
}

}  // namespace
}  // namespace ray
