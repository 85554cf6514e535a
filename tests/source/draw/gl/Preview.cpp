// The preview against the tracer: where no shadow falls and mirrors see nothing but what is around, they are one
// picture; shadows, mirrors and glass come near to it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "R3/Mesh.h"
#include "source/draw/CameraMoves.h"
#include "source/draw/gl/Painter.h"
#include "tests/Project.h"
#include "tests/source/draw/gl/WithPainter.h"

namespace {

constexpr int side = 64;

class Preview : public ray::testing::WithPainter {
 protected:
  R2::Image Drawn(const project::Stage& stage, const ray::RenderSettings& settings, bool with_shadows = false,
                  const ray::DrawingDetail& detail = {}) {
    const auto space = ray::DrawingSpace::Of(stage.scene->root.bounds);
    const ray::Exposure exposure{1, settings.srgb};
    const auto picture = PictureOf(stage.world, settings, space);
    const auto surfaces = painter->surfaces.Upload(picture);
    painter->canvas.Begin(side, side, {});
    painter->surfaces.SetShadows(*surfaces, with_shadows);
    painter->surfaces.DrawProbes(*surfaces);
    auto view = ray::ViewFrom(stage.scene->camera, space, {side, side}, exposure);
    view.depths = {static_cast<float>(settings.trace.zbuffer.near / space.radius),
                   static_cast<float>(settings.trace.zbuffer.far / space.radius)};
    const R2::Color background = stage.scene->background;
    painter->canvas.Begin(side, side, settings.srgb ? EncodeSrgb(background) : background);
    painter->surfaces.DrawSky(*surfaces, view);
    painter->surfaces.Draw(
        *surfaces, ray::ClipFromDrawing(stage.scene->camera, space, stage.scene->root.bounds, {side, side}), view,
        detail);
    return painter->canvas.Read();
  }

  /// The share of pixels that are more than `far` 255ths away from what is traced.
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
constexpr double outline = 0.02;  // of the pixels, which a ball of flat triangles leaves free

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

TEST_P(Preview, IsLitByAWideDiscAsTheTracerIs) {
  // The disc is as near as it is wide, and partly below the horizon of much of the ball.
  const std::string disc = "area_light 0.8 0.7 0.6  1.5 0.5 2  -1.5 -0.5 -2  1.5  0.2 0.1 0.2\n";
  const project::Stage dull(
      project::FromText(camera + disc + Material("0.5 0.6 0.7  0 0 0  0 0 0  0 0 0  1 1 0") + ball));
  EXPECT_LT(Differing(dull, 4), outline);
  // The highlight of a disc is a disc, whose edge the approximation has elsewhere.
  const project::Stage shiny(
      project::FromText(camera + disc + Material("0.2 0.2 0.2  0.4 0.3 0.2  0 0 0  0 0 0  20 1 0") + ball));
  EXPECT_LT(Differing(shiny, 12), 2 * outline);
}

TEST_P(Preview, HasTheTexturesOfTheTracerWhereTheyAre) {
  ray::RenderSettings settings;
  settings.trace.shadows = false;
  EXPECT_LT(Differing(project::Stage(project::Root() / "scenes/texture.scn"), 25, settings), 0.06);
}

TEST_P(Preview, HasTheReliefOfTheTracer) {
  ray::RenderSettings settings;
  settings.trace.shadows = false;
  EXPECT_LT(Differing(project::Stage(project::Root() / "scenes/bump.scn"), 25, settings), 0.06);
}

// The map has one color, so that it does not matter how much of it a pixel shows.
TEST_P(Preview, TiltsNormalsLikeTheTracerOnAnyShapeEvenMirrored) {
  R2::Image map(1, 1);
  map.Set(0, 0, {0.75, 0.35, 0.9});
  const auto slope = std::make_shared<const ray::Texture>(ray::Texture{map});
  ray::RenderSettings settings;
  settings.trace.shadows = false;  // also seen from within a ball
  const std::string lit = camera + "ambient 0.2 0.2 0.2\ndir_light 0.8 0.8 0.8  -1 -0.5 -2\n" +
                          Material("0.7 0.6 0.5  0 0 0  0 0 0  0 0 0  20 1 0");
  for (const char* x : {"1 0 0 0", "-1 0 0 0"})
    for (const std::string shape :
         {"sphere 0  0 0 0  1", "sphere 0  0 0 0  8", "box 0  -1 -1 -1  0.9 0.9 0.5", "cylinder 0  0 0 0  1 1.5",
          "cone 0  0 0 0  1 1.5", "torus 0  0 0 0  0.9 0.3", "disc 0  0 0 0  0.2 0.1 1  1",
          "tri 0  3 -3 -1  -3 -3 -1  0 3 -1", "quad 0  -1 -1 0  1 -1 0  1 1 0  -1 1 0"}) {
      ray::Scene scene =
          project::FromText(lit + "begin -1  " + x + "  0 1 0 0  0 0 1 0  0 0 0 1\n" + shape + "\nend\n");
      scene.materials.back().normal_map = slope;
      EXPECT_LT(Differing(project::Stage(std::move(scene)), 3, settings), 2 * outline) << x << "; " << shape;
    }
}

TEST_P(Preview, SpreadsWhatAGlossyMaterialMirrorsAsTheTracerDoes) {
  const project::Stage around(project::Root() / "scenes/environment_probe.scn");
  ray::Scene scene =
      project::FromText(camera + Material("0 0 0  0.9 0.9 0.9  0 0 0  0 0 0  20 1 0") + "gloss 0  20 256\n" + ball);
  scene.environment = around.scene->environment;
  EXPECT_LT(Differing(project::Stage(std::move(scene)), 20), 0.05);
}

TEST_P(Preview, MirrorsItsBackgroundAndLetsItThrough) {
  const std::string lit = camera + "background 0.5 0.6 0.7\ndir_light 0.5 0.5 0.5  0 0 -1\n";
  const project::Stage mirror(
      project::FromText(lit + Material("0.1 0.1 0.1  0.6 0.6 0.6  0 0 0  0 0 0  20 1 0") + ball));
  EXPECT_LT(Differing(mirror), outline);
  const project::Stage pane(project::FromText(lit + Material("0.1 0.1 0.1  0 0 0  0.5 0.6 0.7  0 0 0  20 1 0") +
                                              "tri 0  -3 -3 -1  3 -3 -1  0 3 -1\n"));
  EXPECT_LT(Differing(pane), outline);
}

TEST_P(Preview, MapsHighlightsAndMirrorsAsTheTracerDoes) {
  R2::Image map(1, 1);
  map.Set(0, 0, {0.75, 0.35, 0.1});
  ray::Scene scene = project::FromText(camera + "background 0.5 0.6 0.7\ndir_light 0.5 0.5 0.5  -1 0 -1\n" +
                                       Material("0.1 0.1 0.1  0.6 0.6 0.6  0 0 0  0 0 0  20 1 0") + ball);
  scene.materials.back().specular_map = std::make_shared<const ray::Texture>(ray::Texture{map});
  EXPECT_LT(Differing(project::Stage(std::move(scene))), outline);
}

TEST_P(Preview, FollowsFresnelAndCoats) {
  const std::string lit = camera + "background 0.5 0.6 0.7\ndir_light 0.5 0.5 0.5  -1 0 -1\n";
  const project::Stage coated(
      project::FromText(lit + Material("0.7 0.2 0.1  0 0 0  0 0 0  0 0 0  20 1 0") + "coat 0 1.5\n" + ball));
  EXPECT_LT(Differing(coated), outline);
  ray::RenderSettings settings;
  settings.trace.fresnel = true;
  settings.trace.max_depth = 1;
  // One surface alone: behind it the ray goes on to the background.
  const project::Stage pane(project::FromText(lit + Material("0.1 0.1 0.1  0 0 0  0.9 0.9 0.9  0 0 0  20 1.5 0") +
                                              "tri 0  -3 -3 -1  3 -3 1  0 3 0\n"));
  EXPECT_LT(Differing(pane, 3, settings), outline);
}

TEST_P(Preview, ShowsTheEnvironmentBehindAndInMirrors) {
  EXPECT_LT(Differing(project::Stage(project::Root() / "scenes/environment_probe.scn"), 20), 0.15);
}

TEST_P(Preview, HasTheShadowsOfTheTracerWhenAskedFor) {
  for (const char* light :
       {"dir_light 0.8 0.7 0.6  -1 -2 -0.5\n", "point_light 0.8 0.7 0.6  3 8 2  1 0 0\n",
        "point_light 0.8 0.7 0.6  1.5 1.8 1  1 0 0\n", "spot_light 0.8 0.7 0.6  1 6 1  -1 -6 -1  1 0 0  0.4 1\n",
        "sphere_light 0.8 0.7 0.6  1.5 1.8 1  0.01  1 0 0\n"}) {
    const project::Stage stage(project::FromText(
        "camera  0 4 8  0 -0.4 -1  0 1 0  0.35  0.01 100\nambient 0.2 0.2 0.2\n" + std::string(light) +
        Material("0.7 0.6 0.5  0 0 0  0 0 0  0 0 0  20 1 0") + "box 0  -4 -1 -4  4 -0.9 4\nsphere 0  0 0.3 0  0.8\n"));
    const double without = Differing(stage, 20);
    EXPECT_GT(without, 0.02) << light;
    EXPECT_LT(Differing(stage, 20, {}, true), without / 5) << light;  // less their edges
  }
}

// A room of mirrors was black.
TEST_P(Preview, ShowsTheSceneInMirrorsAndMirrorsInThem) {
  const std::string room = "camera  0 0 3.8  0 0 -1  0 1 0  0.5  0.01 100\nambient 1 1 1\n" +
                           Material("0 0 0  0 0 0  0 0 0  0 0 0  20 1 0") +                    // 0.2 0.3 0.4
                           "material 0 0 0  0 0 0  1 1 1  0 0 0  0 0 0  20 1 0\n"             // mirrors
                           "box 0 -4 -4 -4  4 4 -3.9  box 0 -4 -4 -4  -3.9 4 4  box 0 3.9 -4 -4  4 4 4\n"
                           "box 0 -4 -4 -4  4 -3.9 4  box 0 -4 3.9 -4  4 4 4  box 0 -4 -4 3.9  4 4 4\n";
  const project::Stage one(project::FromText(room + "sphere 1  0 0 0  1\n"));
  EXPECT_LT(Differing(one, 12), 2 * outline);  // that of the ball, and those of the room in it
  const project::Stage two(project::FromText(room + "sphere 1  -1.1 0 0  1  sphere 1  1.1 0 0  1\n"));
  EXPECT_LT(Differing(two, 25), 0.05);
}

// Where drawing is slow, mirrors show the background alone while the view moves.
TEST_P(Preview, LeavesTheSceneOutOfMirrorsWhenTold) {
  const project::Stage stage(
      project::FromText("camera  0 0 3.8  0 0 -1  0 1 0  0.5  0.01 100\nambient 1 1 1\nbackground 0 0.5 0\n" +
                        Material("0 0 0  0 0 0  0 0 0  0 0 0  20 1 0") +
                        "material 0 0 0  0 0 0  1 1 1  0 0 0  0 0 0  20 1 0\n"
                        "box 0 -4 -4 -4  4 4 -3.9  box 0 -4 -4 3.9  4 4 4  sphere 1  0 0 0  1\n"));
  const auto middle = [&](bool with_mirrors) {
    return Drawn(stage, {}, false, {.has_mirrors = with_mirrors}).At(side / 2, side / 2);
  };
  EXPECT_GT(middle(true).b, 0.3);   // the wall behind the camera
  EXPECT_GT(middle(false).g, 0.4);  // the background
  EXPECT_LT(middle(false).b, 0.1);
}

TEST_P(Preview, ShowsTheModesOfTheTracer) {
  const project::Stage stage(project::FromText(
      "camera  0 1 6  0 -0.1 -1  0 1 0  0.3  0.01 100\nbackground 0.1 0.2 0.3\nambient 0.2 0.2 0.2\n"
      "point_light 0.9 0.8 0.7  3 4 5  1 0 0\n" + Material("0.5 0.4 0.3  0.4 0.4 0.4  0 0 0  0 0 0  20 1 0") + ball));
  using ray::RenderMode;
  for (const RenderMode mode : {RenderMode::toon, RenderMode::gooch, RenderMode::flat, RenderMode::normal_color,
                                RenderMode::zbuffer, RenderMode::uv, RenderMode::uv_color}) {
    ray::RenderSettings settings;
    settings.mode = mode;
    settings.trace.zbuffer = {4, 7};
    const auto surface_only = [&](const R2::Image& image) { return image.At(side / 2, side / 2); };
    settings.width = settings.height = side;
    settings.trace.sampler = ray::SamplerKind::grid;
    const R2::Color traced = Clamped(surface_only(project::Render(stage, settings).image));
    const R2::Color drawn = surface_only(Drawn(stage, settings));
    EXPECT_NEAR(drawn.r, traced.r, 0.02) << static_cast<int>(mode);
    EXPECT_NEAR(drawn.g, traced.g, 0.02) << static_cast<int>(mode);
    EXPECT_NEAR(drawn.b, traced.b, 0.02) << static_cast<int>(mode);
  }
}

// It ended before the horizon, with a black band below the sky.
TEST_P(Preview, HasPlanesUpToTheHorizon) {
  const project::Stage stage(project::FromText(
      "camera  0 1 6  0 0 -1  0 1 0  0.3  0.01 100\nbackground 0 0 0\nambient 1 1 1\n" +
      Material("0 0 0  0 0 0  0 0 0  0 0 0  20 1 0") + ball + "plane 0  0 -1 0  0 1 0\n"));
  const R2::Image drawn = Drawn(stage, {});
  for (int x = 0; x < side; ++x) EXPECT_NEAR(drawn.At(x, side / 2 - 2).b, 0.4, 0.01) << x;
  for (int x = 0; x < side; ++x) EXPECT_EQ(drawn.At(x, side / 2 + 12).b, 0) << x;
}

TEST_P(Preview, HasSoftShadowsFromWideLights) {
  const auto lit_by = [&](const std::string& light) {
    return project::FromText("camera  0 5 6  0 -0.8 -1  0 1 0  0.35  0.01 100\n" + light +
                             Material("0.7 0.6 0.5  0 0 0  0 0 0  0 0 0  20 1 0") +
                             "box 0  -4 -1 -4  4 -0.9 4\nsphere 0  0 0.3 0  0.6\n");
  };
  const project::Stage soft(lit_by("area_light 0.9 0.9 0.9  0 4 0  0 -1 0  1  1 0 0\n"));
  const double without = Differing(soft, 20, {}, false);
  EXPECT_GT(without, 0.04);
  EXPECT_LT(Differing(soft, 20, {}, true), without / 2);
}

// With many lights, depths are drawn first, so that what is hidden is not shaded.
TEST_P(Preview, OfManyLightsHasThePixelsOfOneOfFew) {
  const auto drawn = [this](int lights_too_faint_to_be_seen) {
    std::string text = camera + "dir_light 0.5 0.6 0.4  -1 -1 -1\n";
    for (int i = 0; i < lights_too_faint_to_be_seen; ++i) text += "dir_light 1e-9 1e-9 1e-9  1 -1 -1\n";
    text += Material("0.7 0.6 0.5  0.2 0.2 0.2  0 0 0  0 0 0  20 1 0");
    for (int i = 0; i < 12; ++i)
      text += "sphere 0  " + std::to_string(i % 4 - 1.5) + " " + std::to_string(0.2 * i - 1) + " " +
              std::to_string(0.1 * i) + " 0.6\n";
    return Drawn(project::Stage(project::FromText(text + "box 0  -2 -2 -1  2 2 0.3\n")), {});
  };
  EXPECT_EQ(drawn(2), drawn(0));
  EXPECT_EQ(drawn(9), drawn(0));
}

TEST_P(Preview, OfFewLightsIsDarker) {
  std::string lights;
  for (int i = 0; i < 20; ++i) lights += "point_light 0.03 0.03 0.03  0 0 5  1 0 0\n";
  const project::Stage stage(
      project::FromText(camera + lights + Material("0.9 0.9 0.9  0 0 0  0 0 0  0 0 0  20 1 0") + ball));
  const double all = Drawn(stage, {}).At(side / 2, side / 2).r;
  const double few = Drawn(stage, {}, false, {.is_sparse = true}).At(side / 2, side / 2).r;
  EXPECT_NEAR(few / all, 8.0 / 20, 0.02);
}

TEST_P(Preview, HasSmoothEdges) {
  const project::Stage stage(
      project::FromText(camera + "ambient 1 1 1\n" + Material("0 0 0  0 0 0  0 0 0  0 0 0  20 1 0") + ball));
  const auto space = ray::DrawingSpace::Of(stage.scene->root.bounds);
  const auto surfaces = painter->surfaces.Upload(PictureOf(stage.world, {}, space));
  painter->canvas.Begin(side, side, {});
  painter->coarse.DrawSmoothly([&] {
    painter->canvas.Fill({});
    painter->surfaces.Draw(*surfaces,
                           ray::ClipFromDrawing(stage.scene->camera, space, stage.scene->root.bounds, {side, side}),
                           ray::ViewFrom(stage.scene->camera, space, {side, side}, {}));
  });
  int between = 0;
  const R2::Image image = painter->canvas.Read();
  for (const float channel : image.Channels()) between += channel > 0.05F && channel < 0.15F;
  EXPECT_GT(between, 20);
}

TEST_P(Preview, FollowsSrgbAlsoWhereLightComesThrough) {
  const std::string lit = camera + "background 0.2 0.1 0.05\ndir_light 0.5 0.4 0.3  0 0 -1\n";
  const project::Stage solid(project::FromText(lit + Material("0.7 0.6 0.5  0 0 0  0 0 0  0 0 0  20 1 0") + ball));
  const project::Stage pane(project::FromText(lit + Material("0.1 0.1 0.1  0 0 0  0.8 0.6 0.7  0 0 0  20 1 0") +
                                              "tri 0  -3 -3 -1  3 -3 -1  0 3 -1\n"));
  ray::RenderSettings settings;
  settings.srgb = true;
  EXPECT_LT(Differing(solid, 3, settings), outline);
  EXPECT_LT(Differing(pane, 3, settings), outline);
}

// A scene whose author forgot the lights is still one to be looked at.
TEST_P(Preview, OfAnUnlitSceneIsLitFromTheEye) {
  const project::Stage stage(project::FromText(camera + "point_light 0 0 0  0 0 0  1 0 0\n" +
                                               Material("0.5 0.5 0.5  0 0 0  0 0 0  0 0 0  20 1 0") + ball));
  EXPECT_NEAR(Drawn(stage, {}).At(side / 2, side / 2).g, 0.5, 0.01);
}

// Else a mirror that has only darkness to show could not be told from it.
TEST_P(Preview, ShowsTheRimOfAMirrorInTheDark) {
  const project::Stage stage(project::FromText(camera + "dir_light 0.1 0.1 0.1  0 0 1\n" +
                                               Material("0 0 0  0.9 0.9 0.9  0 0 0  0 0 0  20 1 0") + ball));
  const R2::Image drawn = Drawn(stage, {});
  EXPECT_LT(drawn.At(side / 2, side / 2).g, 0.01);
  double most = 0;
  for (int x = 0; x < side; ++x) most = std::max(most, drawn.At(x, side / 2).g);
  EXPECT_GT(most, 0.05);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Preview);
INSTANTIATE_TEST_SUITE_P(EveryKind, Preview, ::testing::ValuesIn(ray::OffscreenContextKinds()), ray::testing::KindOf);

}  // namespace
