#include "source/integrate/ShadingPoint.h"
#include "tests/Named.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/Project.h"

namespace ray {
namespace {

ShadingPoint Seen(const project::Stage& stage, const R3::Ray& ray) {
  const auto accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
  Workspace workspace;
  const auto hit = accelerator->Intersect(ray, workspace);
  EXPECT_TRUE(hit);
  return ShadingPointAt(stage.world, {.ray = ray, .index = {}}, *hit);
}

TEST(Absorption, ThroughABallAlongItsDiameterIsTheExponentialOfIt) {
  for (const double radius : {0.5, 1.0, 3.0}) {
    const project::Stage stage(
        project::FromText("background 1 1 1 camera 0 0 9  0 0 -1  0 1 0  1e-8  0.01 100 "
                          "point_light 0 0 0  0 9 0  1 0 0 "
                          "material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  10 1.5 0 "
                          "absorb 0  0.1 0.5 2 sphere 0  0 0 0  " +
                          std::to_string(radius)));
    for (const char* mode : {"whitted", "path"}) {
      RenderSettings settings;
      settings.width = settings.height = 1;
      settings.mode = project::Named{mode};
      settings.trace.min_luminance = 0;
      settings.trace.roulette = Roulette::off;
      const R2::Color seen = project::Render(stage, settings).image.At(0, 0);
      EXPECT_NEAR(seen.r, std::exp(-0.1 * 2 * radius), 1e-7) << mode;
      EXPECT_NEAR(seen.g, std::exp(-0.5 * 2 * radius), 1e-7) << mode;
      EXPECT_NEAR(seen.b, std::exp(-2 * 2 * radius), 1e-7) << mode;
    }
  }
}

TEST(Absorption, IsOfTheInsideAloneHoweverLongTheDirection) {
  const project::Stage stage(
      project::FromText("material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  10 1 0 absorb 0  1 1 1 "
                        "sphere 0  0 0 0  1"));
  const ShadingPoint outside = Seen(stage, {{0, 0, 5}, {0, 0, -0.25}});
  EXPECT_TRUE(outside.entering);
  EXPECT_EQ(outside.path.throughput, (R2::Color{1, 1, 1}));
  for (const double length : {0.25, 1.0, 1e3}) {
    const ShadingPoint inside = Seen(stage, {{0, 0, 0.5}, {0, 0, -length}});
    EXPECT_FALSE(inside.entering);
    EXPECT_NEAR(inside.path.throughput.g, std::exp(-1.5), 1e-14) << length;
  }
}

}  // namespace
}  // namespace ray
