#include "source/integrate/Bump.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/integrate/ShadingPoint.h"
#include "tests/Project.h"

namespace ray {
namespace {

/// A picture that rises from left to right by 1 over its width, `steps` texels wide.
std::shared_ptr<const Texture> Ramp(int steps) {
  R2::Image image(steps, 2);
  for (int x = 0; x < steps; ++x)
    for (int y = 0; y < 2; ++y) {
      const double height = (x + 0.5) / steps;
      image.Set(x, y, {height, height, height});
    }
  return std::make_shared<const Texture>(Texture{std::move(image)});
}

/// What a ray from straight above sees at (x, 1, z) of a box from -2 to 2, 1 high.
ShadingPoint SeenFromAbove(double height, double x, double z) {
  Scene scene = project::FromText("material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0 box 0 -2 0 -2 2 1 2");
  scene.materials.back().bump = Ramp(64);
  scene.materials.back().bump_height = height;
  const project::Stage stage(std::move(scene));
  const auto accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
  Workspace workspace;
  const R3::Ray ray{{x, 5, z}, {0, -1, 0}};
  const auto hit = accelerator->Intersect(ray, workspace);
  ShadingPoint surface = ShadingPointAt(stage.world, {.ray = ray, .index = {}}, *hit);
  surface.material = nullptr;  // it goes with the scene
  return surface;
}

// On the upper face u = 1 - (x + 2) / 4, so a slope of 1 over u falls by 1/4 a length towards +x.
TEST(Bump, AnEvenSlopeTiltsTheNormalByItsGradient) {
  for (const double height : {0.5, -0.5, 0.01, 20.0})
    for (const double x : {-1.3, 0.2, 0.9}) {
      const ShadingPoint surface = SeenFromAbove(height, x, 0.4);
      const R3::Vector expected = Unit(R3::Vector{height / 4, 1, 0});
      EXPECT_LT(Length(surface.N - expected), 1e-5) << height << " at " << x;
    }
}

TEST(Bump, TheSurfaceItselfStaysWhereItIs) {
  EXPECT_EQ(SeenFromAbove(3, 0.3, 0.4).at.position, SeenFromAbove(1e-9, 0.3, 0.4).at.position);
}

TEST(Bump, NearAnEdgeThereIsStillANormal) {
  const ShadingPoint surface = SeenFromAbove(0.5, 2 - 1e-9, 0.4);
  EXPECT_NEAR(Length(surface.N), 1, 1e-12);
}

}  // namespace
}  // namespace ray
