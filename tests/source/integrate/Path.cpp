#include "source/integrate/Path.h"
#include "tests/Named.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/Project.h"

namespace ray {
namespace {

RenderSettings Settings(const char* mode = "path") {
  RenderSettings settings = project::Sized(1);
  settings.mode = project::Named{mode};
  settings.trace.min_luminance = 0;
  return settings;
}

R2::Color Shown(const std::string& scene, const RenderSettings& settings) {
  return project::Render(project::Stage(project::FromText(scene)), settings).image.At(0, 0);
}

TEST(Path, EqualsModeWhittedWithoutRandomChoices) {
  // Lights of the language without size, one of them, seen directly or along mirrors: the same formula, the same ray.
  const std::string floor = "camera 3 4 0  -3 -4 0  0 0 -1  0.1  0.01 100 ";
  for (const std::string light : {"point_light 12 6 3  3 4 1  1 0.5 0.1 ", "dir_light 1 0.5 0.25  3 -4 0 ",
                                  "spot_light 9 8 7  1 4 0  0 -1 0  0 0 1  0.7 3 "})
    for (const std::string material : {"material 0.1 0.1 0.1  0.5 0.4 0.3  0 0 0  0 0 0  0.1 0.2 0.3  10 1 0 ",
                                       "material 0 0 0  0 0 0  0.5 0.4 0.3  0 0 0  0 0 0  10 1 0 "}) {
      const std::string scene = floor + "ambient 0.3 0.2 0.1 " + light + material + "box 0  -4 -1 -4  4 0 4";
      RenderSettings path = Settings(), whitted = Settings("whitted");
      path.trace.max_depth = whitted.trace.max_depth = 0;
      path.trace.lights = 0;  // without a choice: the emissive box is a light as well
      EXPECT_EQ(Shown(scene, path), Shown(scene, whitted)) << scene;
    }
}

/// Lights of every kind, with and without attenuation, over a floor with a ball, where lengths are given in a unit
/// `scale` times smaller.
std::string InUnit(double scale) {
  std::ostringstream text;
  const auto lengths = [&](std::initializer_list<double> numbers) {
    for (const double number : numbers) text << ' ' << scale * number;
  };
  const auto falloff = [&] { text << " 0.5 " << 0.25 / scale << ' ' << 0.125 / (scale * scale) << '\n'; };
  text.precision(17);
  text << "background 0.1 0.1 0.2 camera", lengths({0, 1.5, 6}), text << "  0 -0.2 -1  0 1 0  0.4  0.01 1000\n";
  text << "material 0 0 0  0.7 0.6 0.5  0.2 0.2 0.2  0 0 0  0 0 0  20 1 0\n"
          "material 0 0 0  0 0 0  0 0 0  0 0 0  4 3 2  1 1 0\n"
          "dir_light 0.3 0.3 0.4  -1 -2 -1\n";
  text << "point_light 0.5 0.4 0.3", lengths({-2, 3, 2}), text << " 1 0 0\n";
  text << "point_light 2 2 1", lengths({2, 1, 1}), falloff();
  text << "spot_light 3 1 1", lengths({-1, 2, 1}), text << "  0 -1 0  1 0 0  0.9 2\n";
  text << "area_light 1 2 1", lengths({0, 3, 1}), text << "  0 -1 0 ", lengths({0.5}), falloff();
  text << "sphere_light 1 1 2", lengths({1, 2, -1, 0.25}), falloff();
  text << "tri 0", lengths({-4, 0, -4, -4, 0, 4, 4, 0, 4}), text << "\ntri 0", lengths({-4, 0, -4, 4, 0, 4, 4, 0, -4});
  text << "\nsphere 0", lengths({0, 0.8, 0, 0.8}), text << "\ntri 1", lengths({1.5, 2, 0, 2.5, 2, 0, 2, 2, 1});
  text << "\nsphere 1", lengths({-1.5, 0.5, 1, 0.25});
  return text.str();
}

TEST(Path, ScalingLengthsByPowersOfTwoChangesNoByte) {
  // The choice of lights once compared lights without attenuation with areas, so that a scene in other units had more
  // noise.
  RenderSettings settings = Settings();
  settings.width = settings.height = 16;
  settings.samples = 4;
  settings.trace.glossy = true;
  for (const int lights : {-1, 0, 2}) {
    settings.trace.lights = lights;
    const auto one = project::Render(project::Stage(project::FromText(InUnit(1))), settings).image;
    for (const double scale : {0x1p-9, 0.5, 8.0, 1024.0}) {
      const auto other = project::Render(project::Stage(project::FromText(InUnit(scale))), settings).image;
      EXPECT_TRUE(std::ranges::equal(other.Channels(), one.Channels())) << scale << ", lights " << lights;
    }
  }
}

TEST(Path, MirrorsBeyondMaxDepthAreNotFollowed) {
  // Inside a mirror ball that shines 1 and keeps half: 1 + 1/2 + ... + 2^-depth.
  for (int depth = 0; depth < 6; ++depth) {
    RenderSettings settings = Settings();
    settings.trace.max_depth = depth;
    settings.trace.roulette = Roulette::off;
    const R2::Color seen = Shown(
        "camera 0.1 0.2 0.3  0.3 0.1 -1  0 1 0  0.3  0.01 100 point_light 0 0 0  0 0 0  1 0 0 "
        "material 0 0 0  0 0 0  0.5 0.5 0.5  0 0 0  1 1 1  10 1 0 sphere 0  0 0 0  1",
        settings);
    EXPECT_NEAR(seen.r, 2 - std::ldexp(1, -depth), 1e-6) << depth;
  }
}

TEST(Path, EmissiveShapesAreLightsLikeTriangles) {
  const std::string scene =
      "camera 3 1 0  -3 -1 0  0 1 0  1e-7  0.01 100 point_light 0 0 0  0 9 0  1 0 0 "
      "material 0 0 0  0.5 0.5 0.5  0 0 0  0 0 0  0 0 0  10 1 0 material 0 0 0  0 0 0  0 0 0  0 0 0  5 5 5  10 1 0 "
      "box 0  -9 -1 -9  9 0 9 ";
  RenderSettings settings = Settings();
  settings.samples = 256;
  for (const char* lamp : {"sphere 1  0 3 0  1", "box 1  -1 3 -1  1 4 1", "cylinder 1  0 3 0  1 1",
                           "cone 1  0 3 0  1 1", "torus 1  0 3 0  1 0.5", "tri 1  -1 3 -1  1 3 -1  0 3 1"})
    EXPECT_GT(Shown(scene + lamp, settings).r, 0.1) << lamp;
}

TEST(Path, ALightCostsNoRayWhereItCannotShine) {
  // The floor faces away from the light, and black materials need no light.
  for (const std::string material : {"material 0 0 0  0.5 0.5 0.5  0 0 0  0 0 0  0 0 0  10 1 0 ",
                                     "material 0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  10 1 0 "}) {
    const std::string below = material.find("1 1 1") == std::string::npos ? "-5" : "5";
    const auto rays =
        project::Render(
            project::Stage(project::FromText("camera 0 5 0  0 -1 0  0 0 -1  0.1  0.01 100 point_light 1 1 1  0 " +
                                             below + " 0  1 0 0 " + material + "box 0  -4 -1 -4  4 0 4")),
            Settings())
            .rays;
    EXPECT_EQ(rays[RayKind::shadow].rays, 0u) << material;
  }
}

TEST(Path, WithShadowsOffNothingBlocksALight) {
  const std::string scene =
      "camera 0 5 0  0 -1 0  0 0 -1  1e-7  0.01 100 point_light 8 8 8  3 4 0  0 0 1 "
      "material 0 0 0  0.5 0.5 0.5  0 0 0  0 0 0  0 0 0  10 1 0 box 0  -4 -1 -4  4 0 4 sphere 0  1.5 2 0  0.4";
  RenderSettings settings = Settings();
  settings.trace.max_depth = 0;
  EXPECT_EQ(Shown(scene, settings).r, 0);
  settings.trace.shadows = false;
  EXPECT_NEAR(Shown(scene, settings).r, 0.5 * 0.8 * 8 / 25, 1e-6);
}

TEST(Path, TotalReflectionIsCompleteWithFresnelAndLostWithout) {
  // From inside a block of glass, 60 degrees off the normal of its face, beyond the critical angle of 41.8. The
  // reflected light hits a face at the right, 30 degrees off, where most of it leaves.
  const std::string scene = "camera 0 0 0  " + std::to_string(std::sin(1.0471975512)) + " " +
                            std::to_string(std::cos(1.0471975512)) +
                            " 0  0 0 1  1e-7  0.01 100 background 1 1 1 point_light 0 0 0  0 0 0  1 0 0 "
                            "material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  10 1.5 0 box 0  -9 -1 -9  9 1 9";
  RenderSettings settings = Settings();
  settings.trace.max_depth = 1000;
  settings.samples = 16;
  EXPECT_EQ(Shown(scene, settings), (R2::Color{}));
  settings.trace.fresnel = true;
  EXPECT_NEAR(Shown(scene, settings).r, 1, 1e-6);
}

}  // namespace
}  // namespace ray
