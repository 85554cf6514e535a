#include "source/integrate/ShadingPoint.h"
#include "tests/Named.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/integrate/ShadingPoints.h"
#include "tests/Draw.h"
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

TEST(ShadingPoints, MadeTogetherAreThoseMadeOneByOneToTheBit) {
  // Sizes whose areas or squares leave the range of doubles make the loops give up, and others must not suffer.
  for (const char* size : {"1", "1e-90", "1e-200", "1e90", "1e140"}) {
    const std::string s = size;
    const project::Stage stage(
        project::FromText("material 0 0 0  0.2 0.4 0.6  0 0 0  0 0 0  0 0 0  10 1 0 "
                          "tri 0  -" +
                          s + " -" + s + " 0  " + s + " -" + s + " 0  0 " + s + " " + s +
                          " box 0  -1 -1 -3  1 1 -2.5 sphere 0  0.5 0.5 -1  0.25 "
                          "begin -1  0.8 0 0.3 0  0 3 0 0  0.6 0 -0.4 0  0 0 0 1 cone 0  0 0 0  0.4 1 end"));
    const auto accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
    Workspace workspace;
    Draw draw(903);
    std::vector<ShadingPoint> together;
    for (int i = 0; i < 200; ++i) {
      const R3::Ray ray{{draw.Between(-1, 1), draw.Between(-1, 1), i % 2 ? 4.0 : -4.0},
                        {draw.Between(-0.1, 0.1), draw.Between(-0.1, 0.1), i % 2 ? -1.0 : 1.0}};
      const auto hit = accelerator->Intersect(ray, workspace);
      if (!hit) continue;
      together.emplace_back();
      together.back().path.ray = ray;
      together.back().hit = *hit;
    }
    ASSERT_GT(together.size(), 40u);
    CompleteShadingPoints(stage.world, together);
    for (const ShadingPoint& p : together) {
      const ShadingPoint alone = ShadingPointAt(stage.world, p.path, p.hit);
      EXPECT_EQ(p.at.position, alone.at.position) << size;
      EXPECT_EQ(p.at.error, alone.at.error) << size;
      EXPECT_EQ(p.at.normal, alone.at.normal) << size;
      EXPECT_EQ(p.at.shading_normal, alone.at.shading_normal) << size;
      EXPECT_EQ(p.material, alone.material) << size;
      EXPECT_EQ(p.kd, alone.kd) << size;
      EXPECT_EQ(p.wo, alone.wo) << size;
      EXPECT_EQ(p.entering, alone.entering) << size;
      EXPECT_EQ(p.N, alone.N) << size;
      EXPECT_EQ(p.is_smoothed, alone.is_smoothed) << size;
      EXPECT_EQ(p.shadow_origin, alone.shadow_origin) << size;
    }
  }
}

}  // namespace
}  // namespace ray
