// Lens flares: of visible lights, at their place.
#include "source/render/Flare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "source/text/EnumNames.h"
#include "tests/Project.h"

namespace ray {
namespace {

constexpr int flare_width = 80, flare_height = 60;

/// A view along -z; tan(0.4) = 0.4228 to the sides.
std::string TextOf(const std::string& more) {
  return "camera 0 0 0  0 0 -1  0 1 0  .4  1 100 background 0 0 0 " + more + "\n";
}

R2::Image Rendered(const std::string& more, double flare = 1, const char* accelerator = "auto",
                  std::optional<PixelRectangle> crop = {}) {
  RenderSettings settings = project::Sized(flare_width, flare_height);
  settings.flare = flare;
  settings.crop = crop;
  return project::Render(project::Stage(project::FromText(TextOf(more))), settings, {.name = accelerator}).image;
}

R2::Point Brightest(const R2::Image& image) {
  R2::Point at;
  double most = -1;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x)
      if (Luminance(image.At(x, y)) > most) most = Luminance(image.At(x, y)), at = {x + 0.5, y + 0.5};
  return at;
}

double Sum(const R2::Image& image) {
  double sum = 0;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) sum += Luminance(image.At(x, y));
  return sum;
}

TEST(Flare, IsBrightestWhereItsLampIsSeen) {
  // 2 to the right and 1 up of 10 ahead: 40 + 40 0.2 / 0.4228, 30 + 40 0.1 / 0.4228.
  const R2::Point at = Brightest(Rendered("point_light 1 1 1  2 1 -10  1 0 0"));
  EXPECT_NEAR(at.x, 58.9, 0.7);
  EXPECT_NEAR(at.y, 39.5, 0.7);
  const R2::Point of_sun = Brightest(Rendered("dir_light 1 1 1  -2 -1 10"));
  EXPECT_NEAR(of_sun.x, 58.9, 0.7);
  EXPECT_NEAR(of_sun.y, 39.5, 0.7);
}

TEST(Flare, HasGhostsOppositeTheLampThroughTheMiddle) {
  const R2::Image image = Rendered("point_light 1 1 1  2 1 -10  1 0 0");
  EXPECT_GT(Luminance(image.At(40 - 19 + 4, 30 - 9 + 2)), 0.01);
  EXPECT_EQ(Luminance(image.At(40 - 19, 30 + 19)), 0);
}

TEST(Flare, IsAbsentForLampsOutOfSight) {
  EXPECT_GT(Sum(Rendered("point_light 1 1 1  2 1 -10  1 0 0 material 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1 0 "
                        "sphere 0 -2 1 -5 .5")),
            1);
  for (const char* none : {"point_light 1 1 1  2 1 -10  1 0 0 material 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1 0 "
                           "sphere 0 1 .5 -5 .5",
                           "point_light 1 1 1  2 1 10  1 0 0", "point_light 1 1 1  9 1 -10  1 0 0",
                           "point_light 0 0 0  2 1 -10  1 0 0", "spot_light 1 1 1  2 1 -10  0 0 -1  1 0 0  .5 0"})
    EXPECT_EQ(Sum(Rendered(none)), 0) << none;
}

TEST(Flare, FadesAsItsLampGoesBehindAnEdge) {
  double last = 0;
  int between = 0;
  for (int i = 0; i < 20; ++i) {
    const std::string edge = std::to_string(0.95 + 0.005 * i);
    const double sum = Sum(Rendered("point_light 1 1 1  2 0 -10  1 0 0 material 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1 0 "
                                   "box 0 " + edge + " -9 -5.01 9 9 -5"));
    EXPECT_GE(sum, last);
    between += sum > last;
    last = sum;
  }
  EXPECT_GE(between, 4);
}

TEST(Flare, IsTheSameInCropsWithEveryAccelerator) {
  const std::string more =
      "point_light 1 .8 .5  2 1 -10  1 0 0 sphere_light .5 .5 1  -1 -1 -10  .3  1 0 0 sphere -1  0 0 -20 3";
  const R2::Image whole = Rendered(more);
  for (const AcceleratorKind* kind : AcceleratorKinds()) {
    const R2::Image part = Rendered(more, 1, kind->name, PixelRectangle{20, 10, 70, 50});
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 50; ++x) ASSERT_EQ(part.At(x, y), whole.At(x + 20, y + 10)) << kind->name;
  }
}

RenderSettings FlaringSettings(RenderMode mode, double flare = 1) {
  RenderSettings settings = project::Sized(flare_width, flare_height);
  settings.mode = mode;
  settings.flare = flare;
  return settings;
}

TEST(Flare, AloneIsWhatItAddsToTheImage) {
  const project::Stage stage(project::FromText(
      TextOf("ambient .3 .3 .3 point_light 1 .8 .5  2 1 -10  1 0 0 point_light .3 .3 1  -2 1 -10  1 0 0 "
             "sphere -1  0 0 -20 3")));
  for (const auto crop : {std::optional<PixelRectangle>(), std::optional(PixelRectangle{20, 10, 70, 50})}) {
    RenderSettings settings = FlaringSettings(RenderMode::whitted);
    settings.crop = crop;
    const R2::Image with = project::Render(stage, settings).image;
    const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
    const R2::Image alone = FlareAlone(stage.world, *accelerator, settings);
    settings.flare = 0;
    const R2::Image without = project::Render(stage, settings).image;
    ASSERT_GT(Sum(with), Sum(without) + 1);
    // Two glares with eight discs each: at most 16 sums, each rounded to half a unit in the last place of a float.
    for (std::size_t i = 0; i < with.Channels().size(); ++i)
      ASSERT_NEAR(with.Channels()[i] - alone.Channels()[i], without.Channels()[i], 16 * 0x1p-24 * with.Channels()[i]);
  }
}

TEST(Flare, IsOnlyInModesThatShowLight) {
  const project::Stage stage(
      project::FromText(TextOf("point_light 1 1 1  2 1 -10  1 0 0 sphere -1  0 0 -20 3")));
  int of_light = 0;
  for (const char* name : render_modes) {
    const RenderMode mode = *Named<RenderMode>(name);
    const auto with = project::Render(stage, FlaringSettings(mode)).image;
    const auto without = project::Render(stage, FlaringSettings(mode, 0)).image;
    EXPECT_EQ(Sum(with) > Sum(without), ShowsLight(mode)) << name;
    EXPECT_NE(std::ranges::equal(with.Channels(), without.Channels()), ShowsLight(mode)) << name;
    of_light += ShowsLight(mode);
  }
  EXPECT_EQ(of_light, 5);
}

TEST(Flare, IgnoresDefaultLightsWhereSurfacesShineInstead) {
  // The default lights are directional; the first comes from behind the camera and is visible when it is turned around.
  Scene scene = project::FromText("camera 0 0 0  1 1 1  0 1 0  1.2  1 100\n"
                                  "material 0 0 0 0 0 0 0 0 0 0 0 0 1 1 1 1 1 0 sphere 0  -9 -9 -9 1\n");
  ASSERT_TRUE(scene.has_default_lights);
  const project::Stage stage(std::move(scene));
  EXPECT_GT(Sum(project::Render(stage, FlaringSettings(RenderMode::whitted)).image), 1);
  EXPECT_EQ(Sum(project::Render(stage, FlaringSettings(RenderMode::path)).image), 0);
}

}  // namespace
}  // namespace ray
