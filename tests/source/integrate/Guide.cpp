#include "source/integrate/Guide.h"

#include <gtest/gtest.h>

#include "tests/Project.h"

namespace ray {
namespace {

RenderSettings Small(RenderMode mode) {
  RenderSettings settings = project::Sized(24);
  settings.mode = mode;
  return settings;
}

/// Returns the guides of rays through the middles of a small image's pixels, in rows.
std::vector<Guide> GuidesOf(const project::Stage& stage) {
  const RenderSettings settings = Small(RenderMode::whitted);
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  const GuideTracer tracer(stage.world, *accelerator, settings.trace);
  const CameraRays camera = CameraRaysOf(stage.world, settings);
  std::vector<Guide> guides(static_cast<std::size_t>(settings.width * settings.height));
  TraceState state;
  for (int i = 0; i < settings.width * settings.height; ++i) {
    const int column = i % settings.width, row = i / settings.width;
    const CameraSample sample = camera({column, row, RandomKey(0), 0});
    tracer.Trace({&sample, 1}, std::span(guides).subspan(static_cast<std::size_t>(i), 1), state);
  }
  return guides;
}

void ExpectChannels(const std::vector<Guide>& guides, std::size_t first, std::size_t count, const R2::Image& image) {
  for (int i = 0; i < image.Width() * image.Height(); ++i) {
    const R2::Color c = image.At(i % image.Width(), i / image.Width());
    const std::array channels{c.r, c.g, c.b};
    for (std::size_t k = 0; k < count; ++k)
      EXPECT_NEAR(guides[static_cast<std::size_t>(i)][first + k], channels[k], 1e-6) << i;
  }
}

TEST(Guide, ItsLightMatchesWhittedWithoutShadowsOrFaintRays) {
  for (const char* scene : {"refraction.scn", "glass.scn", "depth.scn", "specular.scn"}) {
    const project::Stage stage(project::Root() / "scenes" / scene);
    RenderSettings settings = Small(RenderMode::whitted);
    settings.trace.shadows = false;
    settings.trace.min_luminance = 0.1;
    ExpectChannels(GuidesOf(stage), 0, 3, project::Render(stage, settings).image);
  }
}

TEST(Guide, TheRestAreTheLayersOfTheFirstHit) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  const std::vector<Guide> guides = GuidesOf(stage);
  ExpectChannels(guides, 3, 3, project::Render(stage, Small(RenderMode::albedo)).image);
  ExpectChannels(guides, 6, 3, project::Render(stage, Small(RenderMode::normal)).image);
  const R2::Image depth = project::Render(stage, Small(RenderMode::depth)).image;
  for (std::size_t i = 0; i < guides.size(); ++i) {
    const double distance = depth.At(static_cast<int>(i) % 24, static_cast<int>(i) / 24).r;
    EXPECT_NEAR(guides[i][9], distance > 0 ? 1 / (1 + distance) : 0, 1e-6);
  }
}

TEST(Guide, WithManyLightsItShowsKd) {
  const project::Stage stage(
      project::FromText("camera 0 0 5  0 0 -1  0 1 0  0.5  0.01 100 "
                        "material 0 0 0  0.3 0.4 0.5  0 0 0  0 0 0  0 0 0  10 1 0 sphere 0  0 0 0  1 " +
                        [] {
                          std::string lights;
                          for (int i = 0; i < 17; ++i) lights += "point_light 1 1 1  0 9 0  1 0 0 ";
                          return lights;
                        }()));
  const Guide middle = GuidesOf(stage)[12 * 24 + 12];
  EXPECT_NEAR(middle[0], 0.3, 1e-12);
  EXPECT_NEAR(middle[2], 0.5, 1e-12);
}

}  // namespace
}  // namespace ray
