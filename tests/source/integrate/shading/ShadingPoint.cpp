#include "source/integrate/shading/ShadingPoint.h"
#include "tests/Named.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "source/integrate/lights/LightSampler.h"
#include "source/integrate/shading/ShadingPoints.h"
#include "tests/Accelerators.h"
#include "tests/Draw.h"
#include "tests/Project.h"

namespace ray {
namespace {

ShadingPoint Seen(const project::Stage& stage, const R3::Ray& ray) {
  const auto accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
  Workspace workspace;
  const auto hit = accelerator->Intersect(ray, workspace);
  EXPECT_TRUE(hit);
  return ShadingPointAt(stage.world, ray, {}, *hit);
}

TEST(Absorption, ThroughABallIsExponentialInItsDiameter) {
  for (const double radius : {0.5, 1.0, 3.0}) {
    const project::Stage stage(
        project::FromText("background 1 1 1 camera 0 0 9  0 0 -1  0 1 0  1e-8  0.01 100 "
                          "point_light 0 0 0  0 9 0  1 0 0 "
                          "material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  10 1.5 0 "
                          "absorb 0  0.1 0.5 2 sphere 0  0 0 0  " +
                          std::to_string(radius)));
    for (const char* mode : {"whitted", "path"}) {
      RenderSettings settings = project::Sized(1);
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

TEST(ShadingPoints, InBatchesEqualSingleOnesBitForBit) {
  // Sizes whose areas or squares leave the range of doubles make the loops give up, without an effect on others. Static
  // objects are processed as if nothing else moved.
  const auto compare = [](const std::string& s, bool moves) {
    SCOPED_TRACE(s + (moves ? ", beside what moves" : ""));
    const project::Stage stage(project::FromText(
        "material 0 0 0  0.2 0.4 0.6  0 0 0  0 0 0  0 0 0  10 1 0 "
        "tri 0  -" +
        s + " -" + s + " 0  " + s + " -" + s + " 0  0 " + s + " " + s +
        " box 0  -1 -1 -3  1 1 -2.5 sphere 0  0.5 0.5 -1  0.25 "
        "begin -1  0.8 0 0.3 0  0 3 0 0  0.6 0 -0.4 0  0 0 0 1 cone 0  0 0 0  0.4 1 end " +
        (moves ? "begin -1  1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1 motion 0.2 0.1 0  sphere 0  -1 0.5 1  0.3 end" : "")));
    const auto accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
    Workspace workspace;
    Draw draw(903);
    std::vector<ShadingPoint> together;
    std::vector<R3::Ray> rays;
    std::vector<std::uint32_t> ray_of;
    for (int i = 0; i < 200; ++i) {
      const R3::Ray ray{.origin = {draw.Between(-1, 1), draw.Between(-1, 1), i % 2 ? 4.0 : -4.0},
                        .direction = {draw.Between(-0.1, 0.1), draw.Between(-0.1, 0.1), i % 2 ? -1.0 : 1.0},
                        .time = draw.Between(0, 1)};
      const auto hit = accelerator->Intersect(ray, workspace);
      if (!hit) continue;
      together.emplace_back(ray, PathState{}, *hit);
      ray_of.push_back(static_cast<std::uint32_t>(rays.size()));
      rays.push_back(ray);
    }
    ASSERT_GT(together.size(), 40u);
    CompleteShadingPoints(stage.world, rays, ray_of, together);
    for (std::size_t i = 0; i < together.size(); ++i) {
      const ShadingPoint& p = together[i];
      const ShadingPoint alone = ShadingPointAt(stage.world, rays[i], p.path, p.hit);
      EXPECT_EQ(p.at.normal, alone.at.normal);
      EXPECT_EQ(p.at.shading_normal, alone.at.shading_normal);
      EXPECT_EQ(p.material, alone.material);
      EXPECT_EQ(p.kd, alone.kd);
      EXPECT_EQ(p.wo, alone.wo);
      EXPECT_EQ(p.entering, alone.entering);
      EXPECT_EQ(p.N, alone.N);
      EXPECT_EQ(p.is_smoothed, alone.is_smoothed);
      EXPECT_EQ(p.free_point, alone.free_point);
      EXPECT_EQ(p.leaving, alone.leaving);
      EXPECT_EQ(p.leaving_behind, alone.leaving_behind);
    }
  };
  for (const char* size : {"1", "1e-90", "1e-200", "1e90", "1e140"})
    for (const bool moves : {false, true}) compare(size, moves);
}

TEST(Leaving, AppliesToFlatAndOutwardOfConvexShapes) {
  const project::Stage stage(
      project::FromText("material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  10 1 0 "
                        "tri 0  -1 -1 0  1 -1 0  0 1 0  sphere 0  3 0 0  1  torus 0  6 0 0  1 0.25"));
  const auto from = [&](double x, double y, double dz) { return Seen(stage, {{x, y, -5 * dz}, {0, 0, dz}}); };
  for (const double dz : {1.0, -1.0}) {
    const ShadingPoint flat = from(0, 0, dz), convex = from(3, 0, dz), other = from(7, 0, dz);
    EXPECT_EQ(SpawnRay(flat, {0, 0, -dz}).leaving, 0);
    EXPECT_EQ(SpawnRay(flat, {0, 0.1, dz}).leaving, 0);
    EXPECT_EQ(ShadowRay(flat, {.to_light = {1, 0, -dz}, .is_infinite = true}).leaving, 0);
    EXPECT_EQ(ShadowRay(flat, {.to_light = {1, 0, dz}, .is_infinite = true}).leaving,
              -1);  // it starts on the other side
    EXPECT_EQ(SpawnRay(convex, {0, 1, -dz}).leaving, 1);
    EXPECT_EQ(SpawnRay(flat, {0, 0.1, dz}).leaving_until, R3::infinity);
    EXPECT_EQ(SpawnRay(convex, {0, 1, -dz}).leaving_until, R3::infinity);
    EXPECT_EQ(SpawnRay(other, {0, 0, -dz}).leaving, -1);
    for (const ShadingPoint* entered : {&convex, &other}) {  // they are hit again, but not right there
      const R3::Ray through = SpawnRay(*entered, {0, 0, dz});
      EXPECT_EQ(through.leaving, stage.world.PrimitiveId(entered->hit));
      EXPECT_GT(through.leaving_until, 0);
      EXPECT_LT(through.leaving_until, 1e-9);
    }
  }
  const ShadingPoint inside = Seen(stage, {{3, 0, 0}, {0, 0, 1}});
  EXPECT_EQ(SpawnRay(inside, {0, 0, -1}).leaving, -1);
  EXPECT_EQ(SpawnRay(inside, {0, 0, 1}).leaving, 1);
  EXPECT_EQ(SpawnRay(inside, {0, 0, 1}).leaving_until, R3::infinity);
}

// The data of a departure decide for every surface that is not hit at an angle of less than 2^-10, including the one
// that is left.
TEST(Leaving, ChangesNoAnswerExceptAtGrazingAngles) {
  std::size_t leaving = 0, grazing = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Draw draw(seed);
    const Scene scene = accelerators::RandomScene(draw, 1);
    const World world(scene);
    const auto none = FindAcceleratorKind("none")->Make(world, {});
    Workspace workspace;
    for (int i = 0; i < 500; ++i) {
      R3::Ray ray{R3::Point{draw.Between(-3, 3), draw.Between(-3, 3), draw.Between(-3, 3)}, draw.Direction()};
      // Rays look back at their start.
      std::deque<ShadingPoint> points;
      std::deque<R3::Crossed> crossings;
      std::deque<R3::Departure> beyond;
      for (int bounce = 0; bounce < 6; ++bounce) {
        const auto hit = none->Intersect(ray, workspace);
        R3::Ray testing = ray;
        testing.leaving = -1;
        const auto tested = none->Intersect(testing, workspace);
        if (tested && world.PrimitiveId(*tested) == ray.leaving && tested->t < 1e-6) {
          EXPECT_LT(std::abs(Dot(world.At(ray, *tested).normal, ray.direction)), 0x1p-10);
          ++grazing;
        } else {
          accelerators::ExpectSame(hit, tested, ray, "leaving");
        }
        leaving += ray.leaving != -1;
        if (!hit) break;
        points.push_back(ShadingPointAt(world, ray, {}, *hit));
        ShadingPoint& p = points.back();
        crossings.push_back({world.PrimitiveId(*hit), AsVector(p.at.normal), p.departure.crossed});
        beyond.push_back({p.departure.clearance, p.departure.arriving, &crossings.back()});
        p.beyond = &beyond.back();
        ray = SpawnRay(p, draw.Direction());
      }
    }
  }
  EXPECT_GT(leaving, 1000u);
  EXPECT_LT(grazing, leaving / 500);
}

TEST(Reaching, OnlyKeepsLampsFromBlockingThemselvesByRounding) {
  // Lights of every form, one of them around the surface that it lights, and objects in between.
  const project::Stage stage(project::FromText(
      "material 0 0 0  1 1 1  0 0 0  0 0 0  2 2 2  10 1 0  material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  10 1 0 "
      "sphere 0  0 0 0  9  sphere 0  2 0 0  0.5  tri 0  -2 -1 1  -1 -1 1  -1 1 0  box 0  0 2 0  1 3 1 "
      "begin -1  0.8 0 0.3 0  0 3 0 0  0.6 0 -0.4 -2  0 0 0 1 sphere 0  0 0 0  0.4  end "
      "torus 0  0 -3 0  1 0.3  cone 0  -3 2 0  0.5 1  sphere 1  0 0 0  1  box 1  1 1 1  1.2 1.2 1.2"));
  const LightSampler lights(stage.world, TraceSettings{});
  const auto none = FindAcceleratorKind("none")->Make(stage.world, {});
  Workspace workspace;
  Draw draw(77);
  std::size_t reaching = 0, occluded = 0, rounded = 0;
  for (int i = 0; i < 3000; ++i) {
    const R3::Ray ray{{draw.Between(-4, 4), draw.Between(-4, 4), draw.Between(-4, 4)}, draw.Direction()};
    const auto hit = none->Intersect(ray, workspace);
    if (!hit) continue;
    const ShadingPoint p = ShadingPointAt(stage.world, ray, {}, *hit);
    for (int light = 0; light < lights.Count(); ++light) {
      const auto sample = lights.Sample(p, light, {draw.Between(0, 1), draw.Between(0, 1)});
      if (!sample || !(Dot(p.N, sample->to_light) > 0)) continue;
      const R3::Ray shadow = ShadowRay(p, sample->Target());
      EXPECT_EQ(shadow.reaching, lights[light].Reached());
      R3::Ray testing = shadow;
      testing.leaving = testing.reaching = -1;
      testing.t_max = 1;
      const bool is_occluded = none->IsOccluded(testing, workspace);
      if (none->IsOccluded(shadow, workspace) != is_occluded) {
        const auto blocker = none->Intersect(testing, workspace);
        ASSERT_TRUE(blocker) << lights[light].Describe();
        EXPECT_EQ(stage.world.PrimitiveId(*blocker), shadow.reaching);
        EXPECT_GT(blocker->t, 1 - 0x1p-50);
        ++rounded;
      }
      reaching += shadow.reaching != -1, occluded += is_occluded;
    }
  }
  EXPECT_GT(reaching, 1000u);
  EXPECT_GT(occluded, 1000u);
  EXPECT_LT(rounded, reaching / 1000);
}

}  // namespace
}  // namespace ray
