#include "source/draw/preview/PreviewLights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/Draw.h"
#include "tests/Project.h"

namespace {

ray::PreviewLights LightsOf(const project::Stage& stage, const ray::RenderSettings& settings = {}) {
  return PreviewLightsOf(stage.world, settings, ray::DrawingSpace::Of(stage.scene->root.bounds));
}

TEST(PreviewLights, OfVeryManyAreTheStrongest) {
  std::string text = "sphere -1  0 0 0  1\n";
  for (int i = 0; i < 100; ++i) text += "point_light 1 1 1  " + std::to_string(2 + (i * 37) % 100) + " 0 0  0 0 1\n";
  const auto found = LightsOf(project::Stage(project::FromText(text)));
  EXPECT_EQ(found.left_out, 100 - static_cast<int>(ray::most_preview_lights));
  ASSERT_EQ(found.lights.size(), ray::most_preview_lights);
  for (const ray::PreviewLight& light : found.lights) EXPECT_LT(light.place[0], 2 + ray::most_preview_lights - 0.5);
  EXPECT_FALSE(found.head_light);
}

TEST(PreviewLights, AttenuateInTheWorldForAnySizeOfTheDrawingSpace) {
  const project::Stage stage(project::FromText("sphere -1  0 0 0  10\npoint_light 1 1 1  30 0 0  2 3 4\n"));
  const double radius = ray::DrawingSpace::Of(stage.scene->root.bounds).radius;
  const auto lights = LightsOf(stage).lights;
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].constant, 2);
  EXPECT_DOUBLE_EQ(lights[0].linear, 3 * radius);
  EXPECT_DOUBLE_EQ(lights[0].quadratic, 4 * radius * radius);
}

TEST(PreviewLights, HaveOneForTheTrianglesOfAnEmissiveMesh) {
  const project::Stage stage(
      project::FromText("point_light 0 0 0  0 0 0  1 0 0\nmaterial  0 0 0  0 0 0  0 0 0  0 0 0  2 1 0.5  1 1 0\n"
                        "tri 0  -1 -1 0  1 -1 0  0 2 0\nsphere 0  5 0 0  1\n"));
  const auto whitted = LightsOf(stage).lights;
  ASSERT_EQ(whitted.size(), 1u) << "a sphere that emits lights nothing in mode whitted";
  EXPECT_EQ(whitted[0].color, (R2::Color{2, 1, 0.5}));
  EXPECT_EQ(whitted[0].quadratic, 0);
  ray::RenderSettings settings;
  settings.mode = ray::RenderMode::path;
  const auto path = LightsOf(stage, settings).lights;
  ASSERT_EQ(path.size(), 2u);
  for (const ray::PreviewLight& light : path) {
    EXPECT_EQ(light.constant, 0);
    EXPECT_GT(light.quadratic, 0);
  }
  settings.trace.emission = ray::Emission::color;
  const auto colored = LightsOf(stage, settings).lights;
  ASSERT_EQ(colored.size(), 1u);
  EXPECT_EQ(colored[0].color, whitted[0].color);
  EXPECT_EQ(colored[0].quadratic, 0);
}

TEST(PreviewLights, OfQuadsAreAsStrongAsThoseOfTriangles) {
  const project::Stage stage(
      project::FromText("point_light 0 0 0  0 0 0  1 0 0\nmaterial  0 0 0  0 0 0  0 0 0  0 0 0  2 1 0.5  1 1 0\n"
                        "quad 0  -1 -1 0  1 -1 0  1 1 0  -1 1 0\n"));
  const auto lights = LightsOf(stage).lights;
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].color, (R2::Color{2, 1, 0.5}));
}

TEST(PreviewLights, OfAMeshIsAsStrongAsItsLampsTogether) {
  R3::MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}};
  ray::Scene scene = project::FromText(
      "point_light 0 0 0  0 0 0  1 0 0 material  0 0 0  0 0 0  0 0 0  0 0 0  2 1 0.5  1 1 0 tri 0 0 0 0 1 0 0 0 1 0");
  scene.root.children.back().shape = std::make_shared<const R3::Mesh>(data);
  const project::Stage stage(std::move(scene));
  ray::RenderSettings settings;
  for (const auto& [meshes, strength] :
       {std::pair{ray::EmissiveMeshes::faces, 2}, std::pair{ray::EmissiveMeshes::whole, 1}}) {
    settings.trace.emissive_meshes = meshes;
    const auto lights = LightsOf(stage, settings).lights;
    ASSERT_EQ(lights.size(), 1u);
    EXPECT_EQ(lights[0].color, strength * R2::Color(2, 1, 0.5));
  }
}

TEST(PreviewLights, ComeFromTheEyeOnlyIfNothingElseShines) {
  const std::string unlit = "point_light 0 0 0  0 0 0  1 0 0\nsphere -1  0 0 0  1\n";
  EXPECT_TRUE(LightsOf(project::Stage(project::FromText(unlit))).head_light);
  for (const char* lit : {"ambient 0.1 0.1 0.1\n", "dir_light 1 1 1  0 0 1\n",
                          "material  0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  1 1 0\nsphere 0  3 0 0  1\n"})
    EXPECT_FALSE(LightsOf(project::Stage(project::FromText(unlit + lit))).head_light) << lit;
  EXPECT_FALSE(LightsOf(project::Stage(project::Root() / "scenes/environment.scn")).head_light);
}

// Every point of the scene that a light may reach is within the view of its shadow map, in front of it.
TEST(ShadowViews, CoverTheSceneFromOutsideAndTheViewAheadFromInside) {
  Draw draw(7);
  const auto seen = [](const ray::ClipMatrix& m, const R3::Point& p) {
    const auto row = [&](std::size_t r) { return m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + m[12 + r]; };
    const double w = row(3);
    return w > 0 && std::abs(row(0)) <= w && std::abs(row(1)) <= w && std::abs(row(2)) <= w;
  };
  const auto in_ball = [&] {
    for (;;) {
      const R3::Point p{draw.Between(-1, 1), draw.Between(-1, 1), draw.Between(-1, 1)};
      if (Length(p - R3::Point{}) <= 1) return p;
    }
  };
  for (int i = 0; i < 50; ++i) {
    const R3::Vector towards = Unit(in_ball() - R3::Point{});
    ray::PreviewLight far, outside, inside;
    far.place = ray::AsFloats(towards), far.is_infinite = true;
    outside.place = ray::AsFloats(draw.Between(1.5, 9) * towards);
    inside.place = ray::AsFloats(0.5 * towards);
    for (int k = 0; k < 50; ++k) {
      const R3::Point p = in_ball();
      EXPECT_TRUE(seen(ShadowViewOf(far), p));
      EXPECT_TRUE(seen(ShadowViewOf(outside), p));
      const R3::Vector way = p - (R3::Point{} + 0.5 * towards);
      const double cosine = Dot(Unit(way), -towards);
      EXPECT_TRUE(cosine < std::cos(0.7) || Length(way) < 0.1 || seen(ShadowViewOf(inside), p));
    }
  }
}

}  // namespace
