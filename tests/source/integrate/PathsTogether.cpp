// A path does not depend on the others traced with it.

#include <gtest/gtest.h>

#include <cmath>

#include "source/integrate/CameraRays.h"
#include "source/integrate/Path.h"
#include "source/integrate/debug/RayRecorder.h"
#include "source/render/RenderBlock.h"
#include "source/text/EnumNames.h"
#include "tests/Project.h"

namespace ray {
namespace {

constexpr const char* surfaces_of_every_lobe =
    "camera 0 2 8  0 -0.2 -1  0 1 0  0.4  0.01 100  background 0.2 0.3 0.4  ambient 0.1 0.1 0.1 "
    "point_light 3 3 3  -3 5 4  0.1 0.1 0.1  dir_light 0.4 0.4 0.3  1 -2 -1 "
    "spot_light 9 8 7  0 6 2  0 -1 -0.3  0 0 1  0.7 3  area_light 2 2 2  3 5 1  -0.5 -1 0  0.5  0 0 0.1 "
    "material 0 0 0  0.4 0.4 0.3  0.3 0.3 0.3  0 0 0  0 0 0  20 1 0 "  // both diffuse and a mirror
    "material 0 0 0  0.1 0.1 0.1  0.6 0.5 0.4  0 0 0  0 0 0  40 1 0 gloss 1  50 4 "
    "material 0 0 0  0 0 0  0.1 0.1 0.1  0.8 0.8 0.9  0 0 0  80 1.5 0 "       // glass
    "material 0 0 0  0.6 0.2 0.1  0 0 0  0 0 0  0 0 0  7.5 1 0 coat 3  1.5 "  // under a coat
    "material 0 0 0  0.3 0.5 0.3  0.2 0.2 0.2  0 0 0  0 0 0  7.5 1 0 "        // exponent that is not whole
    "material 0 0 0  0 0 0  0 0 0  0 0 0  2 2 1  1 1 0 "
    "box 0  -5 -1 -5  5 0 5  sphere 1  -2 1 0  1  sphere 2  0.3 1 1  1  sphere 3  2.4 1 0  1  sphere 4  0 0.5 3  0.5 "
    "sphere 5  0 4 -1  0.4 ";

constexpr std::uint32_t samples_per_pixel = 4;

std::vector<CameraSample> CameraSamples(const Scene& scene) {
  constexpr int size = 12;
  const CameraRays camera(scene.camera, {}, true, size, size, TraceSettings().sampler, samples_per_pixel);
  std::vector<CameraSample> seen;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (std::uint32_t i = 0; i < samples_per_pixel; ++i)
        seen.push_back(camera({x, y, PixelKey(RandomKey(1), x, y, 0), i}));
  return seen;
}

/// Returns paths traced together, and one by one with a recorder, which receives complete surfaces: none of their data
/// comes from loops over many.
struct BothWays {
  BothWays(const project::Stage& stage, const TraceSettings& settings)
      : together(SamplesOf(stage).size()), alone(together.size()) {
    const auto accelerator = FindAcceleratorKind("bvh")->Make(stage.world, {});
    const Path path(stage.world, *accelerator, settings);
    const std::vector<CameraSample> seen = SamplesOf(stage);
    path.Li(seen, together, of_all);
    RayRecorder recorder;
    of_one.recorder = &recorder;
    path.Li(seen, alone, of_one);
  }
  static std::vector<CameraSample> SamplesOf(const project::Stage& stage) { return CameraSamples(*stage.scene); }

  std::vector<R2::Color> together, alone;
  TraceState of_all, of_one;
};

TEST(Path, EveryLobeGivesTheSamePathsTogetherAndAlone) {
  const project::Stage stage(project::FromText(surfaces_of_every_lobe));
  for (const bool glossy : {false, true})
    for (const bool fresnel : {false, true})
      for (const auto& [lights, emission] :
           {std::pair{0, Emission::radiance}, {2, Emission::radiance}, {0, Emission::color}, {2, Emission::color}}) {
        TraceSettings settings;
        settings.glossy = glossy, settings.fresnel = fresnel, settings.lights = lights;
        settings.samples = samples_per_pixel;
        settings.emission = emission, settings.emissive_solids_light = true;
        const BothWays both(stage, settings);
        EXPECT_TRUE(both.together == both.alone) << glossy << fresnel << lights << NameOf(emission);
        for (std::size_t kind = 0; kind < ray_kind_names.size(); ++kind) {
          EXPECT_EQ(both.of_all.rays.kinds[kind].rays, both.of_one.rays.kinds[kind].rays) << ray_kind_names[kind];
          EXPECT_GT(both.of_all.rays.kinds[kind].rays, 0u) << ray_kind_names[kind];
        }
      }
}

// Zero times infinity would be NaN.
TEST(Path, APureMirrorStaysFiniteUnderInfiniteLight) {
  const project::Stage stage(project::FromText(
      "camera 0 0 5  0 0 -1  0 1 0  0.4  0.01 100  background 0.2 0.3 0.4  point_light 1 1 1  3 4 5  1e-320 0 0 "
      "material 0 0 0  0 0 0  0 0 0  0 0 0  0 0 0  50 1 0  mirror 0  0.5 0.5 0.5  gloss 0  50 4  sphere 0  0 0 0  1 "));
  TraceSettings settings;
  settings.samples = samples_per_pixel;
  const BothWays both(stage, settings);
  EXPECT_TRUE(both.together == both.alone);
  for (const R2::Color& color : both.alone) EXPECT_TRUE(std::isfinite(Luminance(color)));
}

}  // namespace
}  // namespace ray
