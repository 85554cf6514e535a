#include "source/draw/preview/PreviewLights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/Project.h"

namespace {

ray::PreviewLights LightsOf(const project::Stage& stage, const ray::RenderSettings& settings = {}) {
  return PreviewLightsOf(stage.world, settings, ray::DrawingSpace::Of(stage.scene->root.bounds));
}

TEST(PreviewLights, OfVeryManyAreTheStrongest) {
  std::string text = "sphere -1  0 0 0  1\n";
  for (int i = 0; i < 100; ++i) text += "point_light 1 1 1  " + std::to_string(2 + (i * 37) % 100) + " 0 0  0 0 1\n";
  const auto found = LightsOf(project::Stage(project::FromText(text)));
  EXPECT_EQ(found.left_out, 36);
  ASSERT_EQ(found.lights.size(), ray::most_preview_lights);
  for (const ray::PreviewLight& light : found.lights) EXPECT_LT(light.place[0], 2 + 64 - 0.5);
  EXPECT_FALSE(found.head_light);
}

TEST(PreviewLights, FallOffInTheWorldHoweverLargeTheDrawingSpace) {
  const project::Stage stage(project::FromText("sphere -1  0 0 0  10\npoint_light 1 1 1  30 0 0  2 3 4\n"));
  const double radius = ray::DrawingSpace::Of(stage.scene->root.bounds).radius;
  const auto lights = LightsOf(stage).lights;
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].constant, 2);
  EXPECT_DOUBLE_EQ(lights[0].linear, 3 * radius);
  EXPECT_DOUBLE_EQ(lights[0].quadratic, 4 * radius * radius);
}

TEST(PreviewLights, HaveOneForTheTrianglesOfAMeshThatEmits) {
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

// A lamp in a ceiling casts the shadows of what is below it; what bends around would be in its own.
TEST(PreviewLights, OfFlatEmittersCastShadowsOnTheScenesSide) {
  const std::string emits =
      "point_light 0 0 0  0 0 0  1 0 0\nmaterial  0 0 0  0 0 0  0 0 0  0 0 0  2 1 0.5  1 1 0\n";
  const project::Stage ceiling(
      project::FromText(emits + "quad 0  -1 3 -1  1 3 -1  1 3 1  -1 3 1\nsphere -1  0 0 0  1\n"));
  const auto lights = LightsOf(ceiling).lights;
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_TRUE(lights[0].casts_shadows && lights[0].is_flat);
  EXPECT_LT(lights[0].direction[1], -0.999F) << "downward";
  const double radius = ray::DrawingSpace::Of(ceiling.scene->root.bounds).radius;
  EXPECT_NEAR(lights[0].radius * radius, std::sqrt(4 / std::numbers::pi), 1e-9) << "as large as the quad";

  R3::MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const ray::EmissiveMeshes meshes : {ray::EmissiveMeshes::faces, ray::EmissiveMeshes::whole}) {
    ray::Scene scene = project::FromText(emits + "tri 0  0 0 0  0 1 0  0 0 1");
    scene.root.children.back().shape = std::make_shared<const R3::Mesh>(data);
    ray::RenderSettings settings;
    settings.trace.emissive_meshes = meshes;
    const auto bent = LightsOf(project::Stage(std::move(scene)), settings).lights;
    ASSERT_EQ(bent.size(), 1u);
    EXPECT_FALSE(bent[0].casts_shadows);
  }
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

TEST(PreviewLights, ComeFromTheEyeOnlyWhereNothingElseShines) {
  const std::string unlit = "point_light 0 0 0  0 0 0  1 0 0\nsphere -1  0 0 0  1\n";
  EXPECT_TRUE(LightsOf(project::Stage(project::FromText(unlit))).head_light);
  for (const char* lit : {"ambient 0.1 0.1 0.1\n", "dir_light 1 1 1  0 0 1\n",
                          "material  0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  1 1 0\nsphere 0  3 0 0  1\n"})
    EXPECT_FALSE(LightsOf(project::Stage(project::FromText(unlit + lit))).head_light) << lit;
  EXPECT_FALSE(LightsOf(project::Stage(project::Root() / "scenes/environment.scn")).head_light);
}

}  // namespace
