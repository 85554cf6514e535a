#include "source/integrate/lights/EmissionBounds.h"

#include <gtest/gtest.h>

#include "source/integrate/lights/LightSampler.h"
#include "tests/Draw.h"
#include "tests/Project.h"

namespace ray {
namespace {

// Emission on a shape of each kind, one of them in a group that is rotated, scaled and moving.
const std::string lamp_shapes =
    "camera 0 0 9  0 0 -1  0 1 0  0.4  0.01 100 "
    "material 0 0 0  0.5 0.5 0.5  0 0 0  0 0 0  0 0 0  1 1 0 material 0 0 0  0 0 0  0 0 0  0 0 0  1 2 3  1 1 0 "
    "sphere 1  3 1 0  0.5 tri 1  -1 2 -1  1 2 -1  0 2.5 1 tri 0  -9 -1 -9  9 -1 -9  0 -1 9 "
    "begin 1  0.6 0 0.8 1  0 0.1 0 0  -0.8 0 0.6 -2  0 0 0 1 motion 0.5 1 0 box -1  -1 -1 -1  1 1 1 end ";

TEST(EmissionBounds, ExcludeOnlyRaysThatHitNoEmitter) {
  const project::Stage stage(project::FromText(lamp_shapes));
  const EmissionBounds bounds(stage.world);
  const auto accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
  Workspace workspace;
  Draw draw(1);
  int kept = 0, emitting = 0;
  for (int i = 0; i < 100'000; ++i) {
    const R3::Ray ray{R3::Point{} + draw.Between(0, 6) * draw.Direction(), draw.Scale(-3, 3) * draw.Direction(), 0,
                      R3::infinity, draw.Between(0, 1)};
    const auto hit = accelerator->Intersect(ray, workspace);
    const bool emits = hit && !IsBlack(stage.world.MaterialAt(*hit).emission);
    kept += !bounds.MayBeHitBy(ray);
    emitting += emits;
    ASSERT_TRUE(!emits || bounds.MayBeHitBy(ray)) << i;
  }
  EXPECT_GT(kept, 20'000);
  EXPECT_GT(emitting, 3'000);
}

TEST(EmissionBounds, IncludeRaysAlongTheFacesOfAFlatLamp) {
  const project::Stage stage(
      project::FromText("material 0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  1 1 0 tri 0  -1 2 -1  1 2 -1  0 2 1 "
                        "begin -1  1 0 0 0.1  0 1 0 0.7  0 0 1 0.3  0 0 0 1 box 0  -0.1 -0.1 -0.1  0.1 0.1 0.1 end"));
  const EmissionBounds bounds(stage.world);
  EXPECT_TRUE(bounds.MayBeHitBy({{0, 5, 0}, {0, -1, 0}}));
  EXPECT_TRUE(bounds.MayBeHitBy({{0, 2, -5}, {0, 0, 1}}));
  EXPECT_TRUE(bounds.MayBeHitBy({{-1, 5, -1}, {0, -1, 0}}));
  EXPECT_FALSE(bounds.MayBeHitBy({{0, 5, 0}, {0, 1, 0}}));
  EXPECT_FALSE(bounds.MayBeHitBy({{0, 5, 0}, {1, 0, 0}}));
}

TEST(EmissionBounds, AreUnboundedForAnEndlessLampAndEmptyWithoutLamps) {
  const std::string material = "material 0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  1 1 0 ";
  const project::Stage endless(project::FromText(material + "plane 0  0 -3 0  0 1 0"));
  EXPECT_TRUE(EmissionBounds(endless.world).MayBeHitBy({{0, 5, 0}, {0.1, -0.2, 0}}));
  const project::Stage dark(project::FromText("sphere -1  0 0 0  1"));
  EXPECT_FALSE(EmissionBounds(dark.world).MayBeHitBy({{0, 5, 0}, {0, -1, 0}}));
}

}  // namespace
}  // namespace ray
