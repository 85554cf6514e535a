#include "source/integrate/modes/FirstHit.h"
#include "tests/Named.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/Project.h"

namespace ray {
namespace {

/// A ball of radius 1 in the middle, one of another material far away on the right, seen from a distance of 5.
project::Stage Balls() {
  return project::Stage(
      project::FromText("camera 0 0 5  0 0 -1  0 1 0  0.5  0.01 100 background 0.25 0.5 0.75 "
                        "material 0.9 0.9 0.9  0.1 0.2 0.3  0.2 0.2 0.2  0.4 0.3 0.2  9 9 9  10 1 0 "
                        "sphere 0  0 0 0  1 sphere 0  100 0 0  1"));
}

R2::Image Shown(const project::Stage& stage, const char* mode, int side = 33) {
  RenderSettings settings = project::Sized(side);
  settings.mode = project::Named{mode};
  return project::Render(stage, settings).image;
}

/// Returns the unit direction of the ray through the middle of a pixel.
R3::Vector Towards(int x, int y, int side) {
  const double tangent = std::tan(0.5);
  return R3::Unit({(2 * (x + 0.5) / side - 1) * tangent, (2 * (y + 0.5) / side - 1) * tangent, -1});
}

/// Returns the distance along unit d from (0, 0, 5) to the unit ball; NaN next to it.
double Distance(const R3::Vector& d) {
  const double along = -5 * d.z, root = std::sqrt(along * along - 24);
  return along - root;
}

TEST(FirstHit, AMaterialsOwnColorIsMultipliedByItsTexture) {
  Scene scene = project::FromText(
      "camera 0 0 5  0 0 -1  0 1 0  0.5  0.01 100 "
      "material 0 0 0  0.5 0.5 0.5  0 0 0  0 0 0  0 0 0  10 1 0 sphere 0  0 0 0  1 flat_color 0 1 0.5 1 ");
  R2::Image red(1, 1);
  red.Set(0, 0, {1, 0.5, 0});
  for (Material& material : scene.materials) material.texture = std::make_shared<Texture>(Texture{red});
  const R2::Color shown = Shown(project::Stage(std::move(scene)), "flat", 1).At(0, 0);
  EXPECT_EQ(shown, (R2::Color{1, 0.25, 0}));
}

TEST(FirstHit, ShowsTheExactPropertiesOfABall) {
  const project::Stage stage = Balls();
  constexpr int side = 33;
  const auto depth = Shown(stage, "depth"), normal = Shown(stage, "normal"), albedo = Shown(stage, "albedo"),
             id = Shown(stage, "id"), uv = Shown(stage, "uv");
  int on_ball = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const R3::Vector d = Towards(x, y, side);
      const double t = Distance(d);
      if (std::isnan(t)) {
        EXPECT_EQ(depth.At(x, y), (R2::Color{}));
        EXPECT_EQ(normal.At(x, y), (R2::Color{}));
        EXPECT_EQ(uv.At(x, y), (R2::Color{}));
        EXPECT_EQ(albedo.At(x, y), (R2::Color{0.25, 0.5, 0.75}));
        EXPECT_EQ(id.At(x, y), (R2::Color{-1, -1, -1}));
        continue;
      }
      ++on_ball;
      const R3::Vector n{t * d.x, t * d.y, 5 + t * d.z};
      EXPECT_NEAR(depth.At(x, y).r, t, 1e-6);
      EXPECT_EQ(depth.At(x, y).g, depth.At(x, y).r);
      EXPECT_NEAR(normal.At(x, y).r, n.x, 1e-6);
      EXPECT_NEAR(normal.At(x, y).g, n.y, 1e-6);
      EXPECT_NEAR(normal.At(x, y).b, n.z, 1e-6);
      EXPECT_NEAR(albedo.At(x, y).r, 0.7, 1e-6);  // kd + ks + kt; emission is not part of it
      EXPECT_NEAR(albedo.At(x, y).b, 0.7, 1e-6);
      EXPECT_EQ(id.At(x, y), (R2::Color{0, 0, 0}));
      EXPECT_TRUE(uv.At(x, y).r >= 0 && uv.At(x, y).r <= 1 && uv.At(x, y).g >= 0 && uv.At(x, y).g <= 1);
      EXPECT_EQ(uv.At(x, y).b, 0);
    }
  EXPECT_GT(on_ball, 80);
}

TEST(FirstHit, ColorsForAScreenAreThoseOfTheLayers) {
  const project::Stage stage = Balls();
  constexpr int side = 33;
  const auto depth = Shown(stage, "depth"), normal = Shown(stage, "normal"), flat = Shown(stage, "flat"),
             normal_color = Shown(stage, "normal_color"), zbuffer = Shown(stage, "zbuffer"), uv = Shown(stage, "uv"),
             uv_color = Shown(stage, "uv_color");
  double nearest = R3::infinity, farthest = 0;
  for (const float d : depth.Channels())
    if (d > 0) nearest = std::min<double>(nearest, d), farthest = std::max<double>(farthest, d);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const R2::Color n = normal.At(x, y);
      const bool is_ball = depth.At(x, y).r > 0;
      EXPECT_NEAR(normal_color.At(x, y).g, is_ball ? (n.g + 1) / 2 : 0, 1e-6);
      EXPECT_NEAR(uv_color.At(x, y).r, uv.At(x, y).r, 1e-6);
      EXPECT_EQ(uv_color.At(x, y).g, 0);
      EXPECT_NEAR(uv_color.At(x, y).b, is_ball ? 1 - uv.At(x, y).g : 0, 1e-6);
      EXPECT_NEAR(zbuffer.At(x, y).r, is_ball ? (farthest - depth.At(x, y).r) / (farthest - nearest) : 0, 1e-5);
      EXPECT_NEAR(flat.At(x, y).b, is_ball ? 0.7 : 0.75, 1e-6);  // kd + kr + kt, or the background
    }
}

TEST(FirstHit, AZbufferShowsTheRangeItIsGiven) {
  RenderSettings settings = project::Sized(33);
  settings.mode = RenderMode::zbuffer;
  settings.trace.zbuffer = {3, 13};
  EXPECT_NEAR(project::Render(Balls(), settings).image.At(16, 16).r, 0.9, 1e-6);  // 4 away
  settings.trace.zbuffer = {4.5, 5};
  EXPECT_EQ(project::Render(Balls(), settings).image.At(16, 16).r, 1);
  settings.trace.zbuffer = {1, 2};
  EXPECT_EQ(project::Render(Balls(), settings).image.At(16, 16).r, 0);
}

// A light at the eye: N.L, N.V and V.R are all 1 in the middle of the ball.
TEST(FirstHit, GoochGoesFromCoolToWarmTowardsTheLight) {
  const std::string scene =
      "camera 0 0 5  0 0 -1  0 1 0  0.5  0.01 100 material 0 0 0  .5 .25 0  .125 0 0  0 0 0  0 0 0  10 1 0 "
      "sphere 0  0 0 0  1 ";
  const auto seen = [&](const std::string& light) {
    RenderSettings settings = project::Sized(1);
    settings.mode = RenderMode::gooch;
    settings.trace.gooch = {.blue = 0.4, .yellow = 0.3, .alpha = 0.25, .beta = 0.5};
    return project::Render(project::Stage(project::FromText(scene + light)), settings).image.At(0, 0);
  };
  const R2::Color warm = seen("point_light 1 1 1  0 0 5  1 0 0"), cool = seen("point_light 1 1 1  0 0 -5  1 0 0");
  EXPECT_NEAR(warm.r, 0.3 + 0.5 * 0.5 + 0.125, 1e-6);
  EXPECT_NEAR(warm.g, 0.3 + 0.5 * 0.25, 1e-6);
  EXPECT_NEAR(warm.b, 0, 1e-6);
  EXPECT_NEAR(cool.g, 0.25 * 0.25, 1e-6);
  EXPECT_NEAR(cool.b, 0.4, 1e-6);
  // A black light is ignored: .scn cannot say otherwise that there is none.
  const R2::Color dark = seen("point_light 0 0 0  0 0 5  1 0 0");
  EXPECT_EQ(dark, (R2::Color{}));
}

TEST(FirstHit, NormalsLookBackFromTheInsideToo) {
  const project::Stage stage(project::FromText("camera 0 0 0  0 0 -1  0 1 0  0.5  0.01 100 sphere -1  0 0 0  2"));
  const auto normal = Shown(stage, "normal", 9), depth = Shown(stage, "depth", 9);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) {
      const R3::Vector d = Towards(x, y, 9);
      EXPECT_NEAR(normal.At(x, y).r, -d.x, 1e-6);
      EXPECT_NEAR(normal.At(x, y).b, -d.z, 1e-6);
      EXPECT_NEAR(depth.At(x, y).r, 2, 1e-6);
    }
}

TEST(FirstHit, IdsNumberThePrimitivesInTheOrderOfTheFile) {
  const project::Stage stage(
      project::FromText("camera 0 0 9  0 0 -1  0 1 0  0.5  0.01 100 "
                        "sphere -1  -3 0 0  0.5 box -1  -1 -0.5 -0.5  0 0.5 0.5 tri -1  1 -1 0  2 -1 0  1.5 1 0 "
                        "sphere -1  3 0 0  0.5"));
  const auto id = Shown(stage, "id", 101);
  const auto at = [&](double x) { return id.At(static_cast<int>((x / (9 * std::tan(0.5)) + 1) / 2 * 101), 50).r; };
  EXPECT_EQ(at(-3), 0);
  EXPECT_EQ(at(-0.5), 1);
  EXPECT_EQ(at(1.5), 2);
  EXPECT_EQ(at(3), 3);
  EXPECT_EQ(at(0.5), -1);
}

TEST(FirstHit, CostsOneRayAPixelAndNoOther) {
  const project::Stage stage = Balls();
  for (const char* mode : {"depth", "normal", "uv", "albedo", "id"}) {
    RenderSettings settings = project::Sized(8);
    settings.mode = project::Named{mode};
    const auto rays = project::Render(stage, settings).rays;
    EXPECT_EQ(rays.Total(), 64u) << mode;
    EXPECT_EQ(rays[RayKind::camera].rays, 64u) << mode;
  }
}

}  // namespace
}  // namespace ray
