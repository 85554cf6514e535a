// Path tracing compared with a tracer of one page, which shares none of its methods: the same mean.

#include "tests/oracle/Path.h"

#include <gtest/gtest.h>

#include "tests/Draw.h"
#include "tests/Statistics.h"

namespace {

/// A lamp and a sky over materials that scatter by every lobe, alone and together.
constexpr const char* by_every_lobe =
    "camera 0 2 8  0 -0.15 -1  0 1 0  0.4  0.01 100  background 0.3 0.4 0.5  point_light 0 0 0  0 9 0  1 0 0 "
    "material 0 0 0  0.6 0.5 0.4  0 0 0  0 0 0  0 0 0  1 1 0 "
    "material 0 0 0  0.3 0.4 0.3  0.4 0.4 0.4  0 0 0  0 0 0  20 1 0 "  // diffuse and a mirror
    "material 0 0 0  0.2 0.1 0.1  0.6 0.5 0.5  0 0 0  0 0 0  30 1 0 gloss 2  30 1 "
    "material 0 0 0  0 0 0  0 0 0  0.9 0.9 0.9  0 0 0  80 1.5 0 "  // glass
    "material 0 0 0  0 0 0  0 0 0  0 0 0  3 2.5 2  1 1 0 "
    "quad 0  -5 0 5  5 0 5  5 0 -5  -5 0 -5  sphere 1  -2 1 0  1  sphere 2  0.3 1 -1  1  sphere 3  2.4 1 0.5  1 "
    "box 0  -0.6 0 1.5  0.2 0.8 2.3  sphere 4  0 4 -1  0.8  tri 4  -3 0.5 2  -2 0.5 2  -2.5 1.5 2 ";

TEST(PathOracle, HasTheSameMeanAsATracerOfOnePage) {
  const project::Stage stage(project::FromText(by_every_lobe));
  ray::RenderSettings settings;
  settings.mode = ray::RenderMode::path;
  settings.width = settings.height = 10;
  settings.samples = Count(64, 1024);
  settings.trace.max_depth = 100;
  settings.trace.fresnel = true;
  constexpr int images = 20;
  std::vector<R2::Image> truth;
  for (unsigned seed = 1; seed <= images; ++seed)
    truth.push_back(oracle::Path(stage.world, seed).Picture(settings.width, settings.height, Count(256, 4096)));
  for (const auto strategy : {ray::LightStrategy::mis, ray::LightStrategy::light, ray::LightStrategy::bsdf}) {
    settings.trace.strategy = strategy;
    const auto c = statistics::Compare(statistics::Pictures(stage, settings, images, 1), truth);
    EXPECT_LE(c.worst_pixel, 1) << static_cast<int>(strategy);
    EXPECT_LE(std::abs(c.whole), 4) << static_cast<int>(strategy);
    EXPECT_LE(c.deviation, 0.01) << static_cast<int>(strategy) << ": too noisy to tell anything";
  }
}

}  // namespace
