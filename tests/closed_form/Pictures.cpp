// Pictures of which geometry alone says what every pixel must be.

#include <gtest/gtest.h>

#include <cmath>

#include "R3/ShapeKind.h"
#include "tests/BoundedShapes.h"
#include "tests/Project.h"

namespace {

bool IsLit(const R2::Color& c) { return Luminance(c) > 0; }

TEST(Trap, AUnitSphereFills77PercentOfTheWidth) {
  ray::RenderSettings settings = project::Sized(2000, 1);
  const auto result = project::Render(project::Stage(project::FromText("ambient 1 1 1 sphere -1 0 0 0 1")), settings);
  int lit = 0;
  for (int x = 0; x < settings.width; ++x) lit += IsLit(result.image.At(x, 0));
  // The box of the unit sphere has radius sqrt 3, so the eye is 3 sqrt 3 away and sees the silhouette at asin(1/(3 sqrt
  // 3)).
  const double share = std::tan(std::asin(1 / (3 * std::sqrt(3.0)))) / std::tan(0.25);
  EXPECT_NEAR(lit, share * settings.width, 1.0);
  EXPECT_NEAR(share, 0.77, 0.005);
}

TEST(Trap, AnotherHeightKeepsTheHorizontalView) {
  const project::Stage stage(project::FromText("ambient 1 1 1 sphere -1 0 0 0 1"));
  const auto lit_in_middle_row = [&](int height) {
    ray::RenderSettings settings = project::Sized(301, height);
    const auto image = project::Render(stage, settings).image;
    int lit = 0;
    for (int x = 0; x < settings.width; ++x) lit += IsLit(image.At(x, height / 2));
    return lit;
  };
  EXPECT_EQ(lit_in_middle_row(301), lit_in_middle_row(51));
  EXPECT_EQ(lit_in_middle_row(301), lit_in_middle_row(601));
}

TEST(Extremes, F2_AClearObjectOfIndexOneIsInvisible) {
  const std::string behind =
      "camera 0 0 6 0 0 -1 0 1 0 0.4 0.01 100 background 0.2 0.3 0.4 dir_light 1 1 1 -1 -2 -3 "
      "material 0 0 0 0.5 0.4 0.3 0.2 0.2 0.2 0 0 0 0 0 0 10 1 0 "
      "material 0 0 0 0 0 0 0 0 0 1 1 1 0 0 0 10 1 0 "
      "sphere 0 0.4 0.1 -2 1 box 0 -2 -1.5 -2 -0.5 0.5 -1 ";
  ray::RenderSettings settings = project::Sized(64);
  settings.trace.max_depth = 20;   // clear crossings count, up to four of a torus on each way
  settings.trace.shadows = false;  // a clear blocker still blocks, by rule
  const auto without = project::Render(project::Stage(project::FromText(behind)), settings);
  for (const auto* kind : BoundedShapeKinds()) {
    std::string clear = std::string(kind->name) + " 1";
    for (const double x : kind->example) clear += " " + std::to_string(x);
    const auto with = project::Render(project::Stage(project::FromText(behind + clear)), settings);
    EXPECT_TRUE(with.image == without.image) << clear;
    EXPECT_GT(with.rays[ray::RayKind::transmission].rays, 0u) << clear;
  }
}

TEST(Refraction, AWindowOutOfGlassEndsAtTheCriticalAngle) {
  // From inside a block of index 1.5, 1 above its lower face, the background shows within asin(1/1.5) of the axis and
  // is black beyond. Pixels whose border the circle crosses may be either.
  ray::RenderSettings settings = project::Sized(101);
  settings.trace.min_luminance = 0;
  settings.trace.max_depth = 1;
  const project::Stage stage(
      project::FromText("camera 0 0 0 0 -1 0 0 0 -1 1.0 0.01 100 background 1 1 1 point_light 0 0 0 0 0 0 1 0 0 "
                        "material 0 0 0 0 0 0 0 0 0 1 1 1 0 0 0 10 1.5 0 box 0 -50 -1 -50 50 1 50"));
  const auto image = project::Render(stage, settings).image;
  const double critical = std::tan(std::asin(1 / 1.5)), pixel = 2 * std::tan(1.0) / 101;
  int inside = 0, outside = 0;
  for (int y = 0; y < 101; ++y)
    for (int x = 0; x < 101; ++x) {
      const double tangent = std::hypot((x - 50) * pixel, (y - 50) * pixel);
      if (std::abs(tangent - critical) < pixel / 2) continue;
      EXPECT_EQ(image.At(x, y).r, tangent < critical ? 1 : 0) << x << ' ' << y;
      ++(tangent < critical ? inside : outside);
    }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

TEST(Extremes, A3_RefractionEntersAndLeavesTheRightWayUnderEveryMirror) {
  // A ball under any of the eight sign patterns is the same ball: the picture through it may not change by more than
  // rounding.
  ray::RenderSettings settings = project::Sized(48);
  settings.trace.max_depth = 4;
  const auto picture = [&](int signs) {
    const auto sign = [&](int axis) { return std::string(signs >> axis & 1 ? "-1" : "1"); };
    return project::Render(
               project::Stage(project::FromText(
                   "camera 0 0 6 0 0 -1 0 1 0 0.3 0.01 100 background 0.9 0.8 0.7 point_light 0 0 0 0 0 0 1 0 0 "
                   "material 0 0 0 0 0 0 0 0 0 0.9 0.9 0.9 0 0 0 10 1.5 0 "
                   "material 0 0 0 0 0 0 0 0 0 0 0 0 0.1 0.5 0.2 10 1 0 "
                   "box 1 -5 0.2 -3 5 0.6 -2.5 begin 0 " +
                   sign(0) + " 0 0 0 0 " + sign(1) + " 0 0 0 0 " + sign(2) + " 0 0 0 0 1 sphere -1 0 0 0 1 end")),
               settings)
        .image;
  };
  const auto expected = picture(0);
  for (int signs = 1; signs < 8; ++signs) {
    const auto mirrored = picture(signs);
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x)
        EXPECT_NEAR(Luminance(mirrored.At(x, y)), Luminance(expected.At(x, y)), 1e-6) << signs << ' ' << x << ' ' << y;
  }
}

TEST(Extremes, B3_AGroundSphereShowsNoRingsOfShadowOnItself) {
  // Light grazes a ground of radius 1e6 and 1e9; nothing stands on it, so every pixel below the horizon is lit.
  for (const std::string radius : {"1e6", "1e9"})
    for (const std::string eye : {"0.001", "1", "100"}) {
      const auto image = project::Render(project::Stage(project::FromText("camera 0 " + eye +
                                                                          " 0  0 -0.5 -1  0 1 0  0.4 0.01 100 "
                                                                          "dir_light 1 1 1 -1 -0.3 -1 "
                                                                          "sphere -1 0 -" +
                                                                          radius + " 0 " + radius)),
                                         project::Sized(64))
                             .image;
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) EXPECT_TRUE(IsLit(image.At(x, y))) << radius << ' ' << eye << ' ' << x << ' ' << y;
    }
}

TEST(Extremes, G8_AnEmptySceneIsItsBackground) {
  for (const std::string text : {"background 0.25 0.5 1", "background 0.25 0.5 1 dir_light 1 1 1 0 -1 0",
                                 "background 0.25 0.5 1 camera 0 0 0 0 0 -1 0 1 0 0.3 0.1 10"}) {
    const auto image = project::Render(project::Stage(project::FromText(text)), project::Sized(3, 2)).image;
    for (int i = 0; i < 6; ++i) EXPECT_EQ(image.At(i % 3, i / 3), (R2::Color{0.25, 0.5, 1})) << text;
  }
}

TEST(Extremes, F6_BranchingRaysStopAtTheDescendantLimit) {
  // Each hit both reflects and transmits with weight 1: without a limit 2^depth rays. The spheres are of two materials,
  // since a surface with one on both sides is not there for rays.
  ray::RenderSettings settings = project::Sized(1);
  settings.trace.max_depth = 1'000'000'000;
  settings.trace.min_luminance = 0;
  const auto result =
      project::Render(project::Stage(project::FromText(
                          "camera 0.1 0 0 0.2 0.1 -1 0 1 0 0.3 0.01 100 point_light 0 0 0 0 0 0 1 0 0 "
                          "material 0 0 0 0 0 0 1 1 1 1 1 1 0 0 0 10 1 0 material 0 0 0 0 0 0 1 1 1 1 1 1 0 0 0 10 1 0 "
                          "sphere 0 0 0 0 1 sphere 1 0 0 0 2")),
                      settings);
  EXPECT_GT(result.rays.cut, 0u);
  EXPECT_LE(result.rays.cut, result.rays.Total());
  EXPECT_LE(result.rays.Total(), static_cast<std::uint64_t>(ray::most_descendants) + 3);
}

// A count of surfaces would be a thousand times too small here, and the user is told how many rays are missing.
TEST(Extremes, F6_EveryRayCutByTheLimitIsCounted) {
  ray::RenderSettings settings = project::Sized(1);
  settings.trace.max_depth = 2;
  settings.trace.min_luminance = 0;
  const auto result =
      project::Render(project::Stage(project::FromText("camera 0 0 0  0 0 -1  0 1 0  0.1  0.01 100 "
                                                       "point_light 0 0 0  0 0 0  1 0 0 "
                                                       "material 0 0 0  0 0 0  1 1 1  0 0 0  0 0 0  1 1 0 "
                                                       "gloss 0 1e9 1024\nbox 0  -9 -9 -9  9 9 9")),
                      settings);
  // The first surface sends 1024 rays, and the surfaces that they meet as many each until there are too many.
  constexpr std::uint64_t each = 1024, met = ray::most_descendants / each;
  EXPECT_EQ(result.rays.Total(), 1 + each + met * each);
  EXPECT_EQ(result.rays.cut, (each - met) * each);
}

}  // namespace
