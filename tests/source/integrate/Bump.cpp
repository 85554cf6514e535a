#include "source/integrate/Bump.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

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

/// A normal map of one color.
std::shared_ptr<const Texture> Tilted(const R3::Vector& n) {
  R2::Image image(2, 2);
  for (int i = 0; i < 4; ++i) image.Set(i % 2, i / 2, {(n.x + 1) / 2, (n.y + 1) / 2, (n.z + 1) / 2});
  return std::make_shared<const Texture>(Texture{std::move(image)});
}

struct MappedPlace {
  R3::Vector N, outward;
  R2::Point uv;
  R3::Point position;
};

/// What a ray sees of a scene whose last material has that map.
std::optional<MappedPlace> LookAtMap(const std::string& shape, const R3::Ray& ray, const R3::Vector& map) {
  Scene scene = project::FromText("material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0 " + shape);
  scene.materials.back().normal_map = Tilted(map);
  const project::Stage stage(std::move(scene));
  const auto accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
  Workspace workspace;
  const auto hit = accelerator->Intersect(ray, workspace);
  if (!hit) return {};
  const ShadingPoint s = ShadingPointAt(stage.world, {.ray = ray, .index = {}}, *hit);
  return MappedPlace{s.N, AsVector(s.at.normal), s.at.uv, s.at.position};
}

// On the upper face of a box u falls towards +x.
TEST(NormalMap, TiltsTheNormalAlongUAndV) {
  const R3::Ray down{{0.2, 5, 0.4}, {0, -1, 0}};
  const char* box = "box 0 -2 0 -2 2 1 2";
  EXPECT_LT(Length(LookAtMap(box, down, {0, 0, 1})->N - R3::Vector{0, 1, 0}), 1e-6);
  const R3::Vector along_u = LookAtMap(box, down, {0.6, 0, 0.8})->N, along_v = LookAtMap(box, down, {0, 0.6, 0.8})->N;
  EXPECT_LT(Length(along_u - R3::Vector{-0.6, 0.8, 0}), 1e-6);
  EXPECT_NEAR(along_v.y, 0.8, 1e-6);
  EXPECT_NEAR(std::abs(along_v.z), 0.6, 1e-6);
}

// Of every shape: a little further along what red tilts towards, u is greater and v the same; for green the other way.
TEST(NormalMap, OfEveryShapeLeansToWhereUAndVGrow) {
  for (const char* shape :
       {"sphere 0  0 0 0  1", "box 0  -1 -1 -1  1 1 1", "cylinder 0  0 0 0  1 2", "cone 0  0 0 0  1.5 2",
        "torus 0  0 0 0  1 .4", "plane 0  0 0 0  1 2 3", "tri 0  -5 -5 0  5 -5 0  0 9 1",
        "begin -1  2 0 0 0  0 .5 0 0  .3 0 -1 0  0 0 0 1 sphere 0  0 0 0  1 end"}) {
    const auto ray_at = [](double x, double y) { return R3::Ray{{4 + x, 3 + y, 5}, {-4 + 0.31, -3 + 0.27, -5 + 0.1}}; };
    const auto flat = LookAtMap(shape, ray_at(0, 0), {0, 0, 1});
    ASSERT_TRUE(flat) << shape;
    for (const R3::Vector& map : {R3::Vector{0.6, 0, 0.8}, R3::Vector{0, 0.6, 0.8}}) {
      const R3::Vector lean = Unit(LookAtMap(shape, ray_at(0, 0), map)->N - 0.8 * flat->N);
      constexpr double step = 1e-4;
      const R3::Point above = flat->position + step * lean + step * flat->outward;
      const auto beside = LookAtMap(shape, {above, -flat->outward}, {0, 0, 1});
      ASSERT_TRUE(beside) << shape;
      const double du = beside->uv.x - flat->uv.x, dv = beside->uv.y - flat->uv.y;
      EXPECT_GT(map.x > 0 ? du : dv, 0) << shape;
      EXPECT_LT(std::abs(map.x > 0 ? dv : du), 0.02 * std::abs(map.x > 0 ? du : dv)) << shape;
    }
  }
}

TEST(NormalMap, FromTheInsideIsTheOutsidesTurnedRound) {
  const R3::Vector map{0.48, 0.36, 0.8};
  const auto outside = LookAtMap("sphere 0  0 0 0  1", {{5, 1, 2}, {-5, -0.9, -1.9}}, map);
  const R3::Vector way = outside->position - R3::Point{};
  const auto inside = LookAtMap("sphere 0  0 0 0  1", {{0, 0, 0}, way}, map);
  EXPECT_LT(Length(outside->N + inside->N), 1e-5);
}

TEST(NormalMap, OfBlackTellsNothing) {
  const auto seen = LookAtMap("sphere 0  0 0 0  1", {{5, 1, 2}, {-5, -0.9, -1.9}}, {-1, -1, -1});
  EXPECT_LT(Length(seen->N - seen->outward), 1e-12);
}

}  // namespace
}  // namespace ray
