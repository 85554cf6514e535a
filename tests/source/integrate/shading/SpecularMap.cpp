// The effects of a specular map, and the values that it does not change.

#include <gtest/gtest.h>

#include <string>

#include "source/integrate/CameraRays.h"
#include "source/integrate/Path.h"
#include "source/integrate/debug/RayRecorder.h"
#include "source/render/RenderBlock.h"
#include "tests/Farthest.h"
#include "tests/Named.h"
#include "tests/Project.h"

namespace ray {
namespace {

std::shared_ptr<const Texture> Plain(const R2::Color& color) {
  R2::Image image(2, 2);
  for (int i = 0; i < 4; ++i) image.Set(i % 2, i / 2, color);
  return std::make_shared<const Texture>(Texture{std::move(image)});
}

/// Black left of the middle, white right of it.
std::shared_ptr<const Texture> Halves(int columns) {
  R2::Image image(columns, 1);
  for (int x = 0; x < columns; ++x) image.Set(x, 0, x < columns / 2 ? R2::Color{} : R2::Color{1, 1, 1});
  return std::make_shared<const Texture>(Texture{std::move(image)});
}

project::Stage WithMap(const std::string& text, std::shared_ptr<const Texture> map) {
  Scene scene = project::FromText(text);
  for (Material& material : scene.materials) material.specular_map = map;
  return project::Stage(std::move(scene));
}

RenderSettings Small(const std::string& mode) {
  RenderSettings settings = project::Sized(24);
  settings.samples = 4;
  settings.mode = project::Named{mode};
  return settings;
}

/// Shapes in the world and in a group, shiny by `ks` and with `more` in their material, under a light and a sky.
std::string ShinyThings(const std::string& ks, const std::string& more) {
  return "camera 0 1 7  0 -.1 -1  0 1 0  .4 .01 100  background .3 .5 .8  ambient .1 .1 .1  dir_light .6 .6 .6  1 -1 "
         "-1 "
         "material .2 .2 .2  .2 .3 .2  " +
         ks + "  .1 .1 .1  0 0 0  20 1.5 0 " + more +
         " sphere 0  -1.5 0 0  .8  box 0  -4 -1.5 -4  4 -1 2  quad 0  -.5 -.5 0  1 -.5 0  1 1 0  -.5 1 0 "
         "begin 0 scale 1.2 translate 1.5 0 0 sphere 0  0 0 0  .6  tri 0  0 .8 0  1 .8 0  0 1.5 0 end ";
}

TEST(SpecularMap, OfOneColorIsKsTimesThatColor) {
  for (const char* mode : {"whitted", "path", "albedo", "toon", "gooch"})
    for (const std::string more : {"", "gloss 0  30 2", "coat 0  1.4", "mirror 0  .4 .8 .8"}) {
      const bool has_mirror = more.starts_with("mirror");
      const auto scaled = ShinyThings(".2 .3 .4", has_mirror ? "mirror 0  .1 .4 .4" : more);
      RenderSettings settings = Small(mode);
      settings.trace.fresnel = settings.trace.internal_reflection = true;
      const auto mapped = project::Render(WithMap(ShinyThings(".8 .6 .8", more), Plain({.25, .5, .5})), settings).image;
      EXPECT_LT(Farthest(mapped, project::Render(project::Stage(project::FromText(scaled)), settings).image), 1e-6)
          << mode << ' ' << more;
      const auto unmapped = project::Render(project::Stage(project::FromText(ShinyThings(".8 .6 .8", more))), settings);
      EXPECT_GT(Farthest(mapped, unmapped.image), mode == std::string("gooch") ? 0.01 : 0.1) << mode << ' ' << more;
    }
}

TEST(SpecularMap, ThatIsHalfBlackMirrorsOnOneHalfAlone) {
  constexpr int size = 64;
  const std::string wall =
      "camera 0 0 1  0 0 -1  0 1 0  .78539816339744831  .01 100  background .25 .5 1  dir_light 0 0 0 0 0 -1 "
      "material 0 0 0  0 0 0  1 1 1  0 0 0  0 0 0  9 1 0  quad 0  -1 -1 0  1 -1 0  1 1 0  -1 1 0 ";
  for (const char* mode : {"whitted", "path"}) {
    RenderSettings settings = Small(mode);
    settings.width = settings.height = size, settings.trace.max_depth = 1;
    const R2::Image image = project::Render(WithMap(wall, Halves(size)), settings).image;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const bool is_blended = x == 0 || x == size - 1 || x == size / 2 || x == size / 2 - 1;
        if (is_blended) continue;
        EXPECT_EQ(image.At(x, y), (x < size / 2 ? R2::Color{} : R2::Color{.25, .5, 1})) << mode << x << ' ' << y;
      }
  }
}

// kd / pi over the hemisphere and the mirror together lose nothing, so the ball is invisible.
TEST(SpecularMap, LeavesTheDiffuseLobeWhatItTakesFromMirrors) {
  const std::string furnace =
      "background 1 1 1  camera 0 0 6  0 0 -1  0 1 0  .3  .01 100  dir_light 0 0 0 0 0 -1 "
      "material 0 0 0  .75 .75 .75  1 1 1  0 0 0  0 0 0  30 1 0  sphere 0  0 0 0  1 ";
  const R2::Image image = project::Render(WithMap(furnace, Plain({.25, .25, .25})), Small("path")).image;
  for (const float channel : image.Channels()) ASSERT_NEAR(channel, 1, 1e-6);
}

TEST(SpecularMap, NeverReflectsMoreThanArrives) {
  for (const std::string more : {"", "gloss 0  30 1", "coat 0  1.5"}) {
    const project::Stage stage =
        WithMap("background 1 1 1  dir_light 0 0 0 0 0 -1  material 0 0 0  0 0 0  1 1 1  0 0 0  0 0 0  30 1 0 " + more +
                    " sphere 0  0 0 0  1 ",
                Halves(8));
    const R2::Image image = project::Render(stage, Small("path")).image;
    for (const float channel : image.Channels()) ASSERT_LE(channel, 1 + 1e-6);
    EXPECT_GT(image.At(12, 12).r + image.At(11, 12).r + image.At(9, 12).r, 0) << more;
  }
}

// A recorder receives surfaces one at a time; without one, points are completed and scattered together.
TEST(SpecularMap, GivesTheSameBytesTogetherAndOneByOne) {
  for (const std::string more : {"", "gloss 0  30 2", "coat 0  1.4"}) {
    const project::Stage stage = WithMap(ShinyThings(".8 .6 .8", more), Halves(6));
    const auto accelerator = FindAcceleratorKind("bvh")->Make(stage.world, {});
    TraceSettings settings;
    settings.samples = 4, settings.emission = Emission::color;
    const CameraRays camera(stage.scene->camera, {}, true, 16, 16, settings.sampler, 4);
    std::vector<CameraSample> seen;
    for (int pixel = 0; pixel < 16 * 16; ++pixel)
      for (std::uint32_t i = 0; i < 4; ++i)
        seen.push_back(camera({pixel % 16, pixel / 16, PixelKey(RandomKey(1), pixel % 16, pixel / 16, 0), i}));
    const Path path(stage.world, *accelerator, settings);
    std::vector<R2::Color> together(seen.size()), alone(seen.size());
    TraceState of_all, of_one;
    path.Li(seen, together, of_all);
    RayRecorder recorder;
    of_one.recorder = &recorder;
    path.Li(seen, alone, of_one);
    EXPECT_TRUE(together == alone) << more;
  }
}

TEST(SpecularMap, LooksTheSameUnderEveryAccelerator) {
  const project::Stage stage = WithMap(ShinyThings(".8 .6 .8", ""), Halves(6));
  for (const char* mode : {"whitted", "path"}) {
    const R2::Image image = project::Render(stage, Small(mode), {.name = "none"}).image;
    for (const char* name : {"graph", "grid", "octree", "bvh"})
      EXPECT_TRUE(project::Render(stage, Small(mode), {.name = name}).image == image) << name << ' ' << mode;
  }
}

}  // namespace
}  // namespace ray
