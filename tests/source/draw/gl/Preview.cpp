// The preview compared with the tracer: without shadows, and with mirrors that reflect only the surroundings, they are
// the same image; hard shadows are close to it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "R3/Mesh.h"
#include "source/draw/CameraMoves.h"
#include "source/draw/gl/Painter.h"
#include "source/parse/Parse.h"
#include "tests/Project.h"
#include "tests/source/draw/gl/WithPainter.h"

namespace {

constexpr int side = 64;

class Preview : public ray::testing::WithPainter {
 protected:
  R2::Image Drawn(const project::Stage& stage, const ray::RenderSettings& settings, bool with_shadows = false) {
    const auto space = ray::DrawingSpace::Of(stage.scene->root.bounds);
    const ray::Exposure exposure{1, settings.srgb};
    const auto surfaces = painter->surfaces.Upload(PreviewOf(stage.world, settings, space));
    const auto view = ray::ViewFrom(stage.scene->camera, space, {side, side}, exposure);
    const R2::Color background = stage.scene->background;
    painter->canvas.Begin(side, side, settings.srgb ? EncodeSrgb(background) : background);
    painter->surfaces.DrawSky(*surfaces, view);
    painter->surfaces.Draw(
        *surfaces, ray::ClipFromDrawing(stage.scene->camera, space, stage.scene->root.bounds, {side, side}), view,
        with_shadows);
    return painter->canvas.Read();
  }

  /// Returns the share of pixels that differ by more than `far`/255 from the traced image.
  double Differing(const project::Stage& stage, double far = 3, ray::RenderSettings settings = {},
                   bool with_shadows = false) {
    settings.width = settings.height = side;
    settings.trace.sampler = ray::SamplerKind::grid;  // through the middles of pixels, as OpenGL does
    settings.trace.shadow_samples = 256;
    R2::Image traced = project::Render(stage, settings).image;
    const R2::Image drawn = Drawn(stage, settings, with_shadows);
    int count = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const R2::Color color = Clamped(traced.At(x, y));
        const R2::Color off = (settings.srgb ? EncodeSrgb(color) : color) - drawn.At(x, y);
        count += std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)}) > far / 255;
      }
    return static_cast<double>(count) / (side * side);
  }
};

const std::string camera = "camera  0 0 6  0 0 -1  0 1 0  0.25  0.01 100\n";
const std::string ball = "sphere 0  0 0 0  1\n";
constexpr double outline = 0.02;  // of the pixels, which a ball of flat triangles does not cover

std::string Material(const std::string& rest) { return "material  0.2 0.3 0.4  " + rest + "\n"; }

TEST_P(Preview, MatchesTheTracerUnderEveryKindOfLight) {
  const std::map<std::string, std::string> lights{
      {"dir_light", "dir_light 0.8 0.7 0.6  -1 -1 -2\n"},
      {"point_light", "point_light 0.8 0.7 0.6  2 2 4  0.2 0.1 0.05\n"},
      {"spot_light", "spot_light 0.8 0.7 0.6  1 1 4  -1 -1 -4  0.2 0.1 0.02  0.2 5\n"},
      {"area_light", "area_light 0.8 0.7 0.6  1 1 4  -1 -1 -4  0.1  0.2 0.1 0.02\n"},
      {"sphere_light", "sphere_light 0.8 0.7 0.6  1 1 4  0.02  0.2 0.1 0.02\n"}};
  for (const ray::LightKind* kind : ray::LightKinds()) {
    ASSERT_TRUE(lights.count(kind->name)) << kind->name;
    const project::Stage stage(project::FromText(camera + "ambient 0.3 0.3 0.3\n" + lights.at(kind->name) +
                                                 Material("0.5 0.6 0.7  0.4 0.3 0.2  0 0 0  0.05 0 0  20 1 0") + ball));
    EXPECT_LT(Differing(stage), outline) << kind->name;
  }
}

TEST_P(Preview, ShowsTheColorsOfVertices) {
  R3::MeshData data;
  data.positions = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}};
  data.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  const auto stage = [&](bool asks) {
    ray::Scene scene = project::FromText(camera + "ambient 0.3 0.3 0.3  dir_light 0.8 0.7 0.6  -1 -1 -2\n" +
                                         Material("0.5 0.6 0.7  0 0 0  0 0 0  0 0 0  20 1 0"));
    ray::Node node;
    node.shape = std::make_shared<const R3::Mesh>(data);
    node.material = 1;
    SetBounds(node);
    scene.root.children.push_back(std::move(node));
    SetBounds(scene.root);
    scene.materials[1].has_vertex_colors = asks;
    return project::Stage(std::move(scene));
  };
  EXPECT_EQ(Differing(stage(true)), 0);
  EXPECT_EQ(Differing(stage(false)), 0);
}

TEST_P(Preview, HasTheTexturesOfTheTracerInPlace) {
  ray::RenderSettings settings;
  settings.trace.shadows = false;
  ray::Scene scene = ray::Parse(project::Root() / "scenes/texture.scn", {}).scene;
  for (ray::Material& material : scene.materials) material.kr = {};  // with mirrors that reflect only the sky
  EXPECT_LT(Differing(project::Stage(std::move(scene)), 25, settings), 0.06);
}

TEST_P(Preview, ReflectsAndTransmitsItsBackground) {
  const std::string lit = camera + "background 0.5 0.6 0.7\ndir_light 0.5 0.5 0.5  0 0 -1\n";
  const project::Stage mirror(
      project::FromText(lit + Material("0.1 0.1 0.1  0.6 0.6 0.6  0 0 0  0 0 0  20 1 0") + ball));
  EXPECT_LT(Differing(mirror), outline);
  const project::Stage pane(project::FromText(lit + Material("0.1 0.1 0.1  0 0 0  0.5 0.6 0.7  0 0 0  20 1 0") +
                                              "tri 0  -3 -3 -1  3 -3 -1  0 3 -1\n"));
  EXPECT_LT(Differing(pane), outline);
}

TEST_P(Preview, ShowsTheEnvironmentBehindAndInMirrors) {
  EXPECT_LT(Differing(project::Stage(project::Root() / "scenes/environment_probe.scn"), 20), 0.15);
}

TEST_P(Preview, HasTheShadowsOfTheTracerOnRequest) {
  for (const char* light :
       {"dir_light 0.8 0.7 0.6  -1 -2 -0.5\n", "point_light 0.8 0.7 0.6  3 8 2  1 0 0\n",
        "point_light 0.8 0.7 0.6  1.5 1.8 1  1 0 0\n", "spot_light 0.8 0.7 0.6  1 6 1  -1 -6 -1  1 0 0  0.4 1\n",
        "sphere_light 0.8 0.7 0.6  1.5 1.8 1  0.01  1 0 0\n"}) {
    const project::Stage stage(project::FromText(
        "camera  0 4 8  0 -0.4 -1  0 1 0  0.35  0.01 100\nambient 0.2 0.2 0.2\n" + std::string(light) +
        Material("0.7 0.6 0.5  0 0 0  0 0 0  0 0 0  20 1 0") + "box 0  -4 -1 -4  4 -0.9 4\nsphere 0  0 0.3 0  0.8\n"));
    const double without = Differing(stage, 20);
    EXPECT_GT(without, 0.02) << light;
    EXPECT_LT(Differing(stage, 20, {}, true), without / 5) << light;  // except for their edges
  }
}

// It once ended before the horizon, with a black band below the sky.
TEST_P(Preview, HasPlanesUpToTheHorizon) {
  const project::Stage stage(project::FromText(
      "camera  0 1 6  0 0 -1  0 1 0  0.3  0.01 100\nbackground 0 0 0\nambient 1 1 1\n" +
      Material("0 0 0  0 0 0  0 0 0  0 0 0  20 1 0") + ball + "plane 0  0 -1 0  0 1 0\n"));
  const R2::Image drawn = Drawn(stage, {});
  for (int x = 0; x < side; ++x) EXPECT_NEAR(drawn.At(x, side / 2 - 2).b, 0.4, 0.01) << x;
  for (int x = 0; x < side; ++x) EXPECT_EQ(drawn.At(x, side / 2 + 12).b, 0) << x;
}

TEST_P(Preview, HasSmoothEdges) {
  const project::Stage stage(
      project::FromText(camera + "ambient 1 1 1\n" + Material("0 0 0  0 0 0  0 0 0  0 0 0  20 1 0") + ball));
  const auto space = ray::DrawingSpace::Of(stage.scene->root.bounds);
  const auto surfaces = painter->surfaces.Upload(PreviewOf(stage.world, {}, space));
  painter->canvas.Begin(side, side, {});
  painter->coarse.DrawSmoothly([&] {
    painter->canvas.Fill({});
    painter->surfaces.Draw(*surfaces,
                           ray::ClipFromDrawing(stage.scene->camera, space, stage.scene->root.bounds, {side, side}),
                           ray::ViewFrom(stage.scene->camera, space, {side, side}, {}), false);
  });
  int between = 0;
  const R2::Image image = painter->canvas.Read();
  for (const float channel : image.Channels()) between += channel > 0.05F && channel < 0.15F;
  EXPECT_GT(between, 20);
}

TEST_P(Preview, FollowsSrgbAlsoForTransmittedLight) {
  const std::string lit = camera + "background 0.2 0.1 0.05\ndir_light 0.5 0.4 0.3  0 0 -1\n";
  const project::Stage solid(project::FromText(lit + Material("0.7 0.6 0.5  0 0 0  0 0 0  0 0 0  20 1 0") + ball));
  const project::Stage pane(project::FromText(lit + Material("0.1 0.1 0.1  0 0 0  0.8 0.6 0.7  0 0 0  20 1 0") +
                                              "tri 0  -3 -3 -1  3 -3 -1  0 3 -1\n"));
  ray::RenderSettings settings;
  settings.srgb = true;
  EXPECT_LT(Differing(solid, 3, settings), outline);
  EXPECT_LT(Differing(pane, 3, settings), outline);
}

// A scene whose author forgot the lights should still be visible.
TEST_P(Preview, OfAnUnlitSceneIsLitFromTheEye) {
  const project::Stage stage(project::FromText(camera + "point_light 0 0 0  0 0 0  1 0 0\n" +
                                               Material("0.5 0.5 0.5  0 0 0  0 0 0  0 0 0  20 1 0") + ball));
  EXPECT_NEAR(Drawn(stage, {}).At(side / 2, side / 2).g, 0.5, 0.01);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Preview);
INSTANTIATE_TEST_SUITE_P(EveryKind, Preview, ::testing::ValuesIn(ray::OffscreenContextKinds()), ray::testing::KindOf);

}  // namespace
