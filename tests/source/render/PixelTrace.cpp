#include "source/render/PixelTrace.h"
#include "tests/Named.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "source/text/NumberText.h"
#include "tests/Project.h"

namespace ray {
namespace {

struct Traced {
  explicit Traced(const std::string& scene, RenderSettings chosen)
      : stage(project::Root() / "scenes" / scene),
        settings(std::move(chosen)),
        accelerator(FindAcceleratorKind("bvh")->Make(stage.world, {})) {}

  project::Stage stage;
  RenderSettings settings;
  std::unique_ptr<const Accelerator> accelerator;

  PixelTrace Pixel(int column, int row) const {
    return PixelTracer(stage.world, *accelerator, settings).Trace(column, row, settings.samples);
  }
};

RenderSettings Settings(const std::string& mode, int side, int samples = 1) {
  RenderSettings settings;
  settings.mode = project::Named{mode};
  settings.width = settings.height = side;
  settings.samples = samples;
  return settings;
}

bool AreClose(const R2::Color& a, const R2::Color& b) {
  const double scale = 1 + std::abs(a.r) + std::abs(a.g) + std::abs(a.b);
  const R2::Color d = a - b;
  return std::abs(d.r) + std::abs(d.g) + std::abs(d.b) < 1e-12 * scale;
}

const char* const scenes[] = {"hello.scn", "glass.scn",    "area_light.scn",  "emissive.scn", "environment.scn",
                              "lens.scn",  "indirect.scn", "many_lights.scn", "texture.scn",  "total_reflection.scn"};

TEST(PixelTrace, EverySampleIsTheSumOfItsRaysContributions) {
  for (const char* scene : scenes)
    for (const char* mode : {"whitted", "path"}) {
      const Traced traced(scene, Settings(mode, 100, 2));
      for (int row = 0; row < 100; row += 25)
        for (int column = 0; column < 100; column += 25) {
          const PixelTrace trace = traced.Pixel(column, row);
          std::vector<R2::Color> sums;
          std::vector<std::size_t> sample_of;
          for (const RecordedRay& ray : trace.rays) {
            if (ray.parent == RecordedRay::none) sums.emplace_back();
            sample_of.push_back(ray.parent == RecordedRay::none ? sums.size() - 1
                                                                : sample_of[static_cast<std::size_t>(ray.parent)]);
            sums[sample_of.back()] += ray.contribution;
          }
          ASSERT_EQ(sums.size(), trace.radiances.size());
          for (std::size_t i = 0; i < sums.size(); ++i)
            EXPECT_TRUE(AreClose(sums[i], trace.radiances[i])) << scene << " " << mode << " " << column << " " << row;
        }
    }
}

TEST(PixelTrace, SamplesAreThoseOfTheImage) {
  for (const char* scene : scenes) {
    const Traced traced(scene, Settings("whitted", 40, 3));
    const R2::Image image = Render(traced.stage.world, *traced.accelerator, traced.settings).image;
    for (const auto& [x, y] : {std::pair{3, 5}, {20, 20}, {39, 0}}) {
      const R2::Color mean = traced.Pixel(x, y).Mean(), shown = image.At(x, y);
      constexpr double float_rounding = 1e-6;
      EXPECT_NEAR(mean.r, shown.r, float_rounding * (1 + shown.r)) << scene;
      EXPECT_NEAR(mean.b, shown.b, float_rounding * (1 + shown.b)) << scene;
    }
  }
}

// An image whose error is measured consists of two images of half the samples. The pixel's rays were once all of the
// first.
TEST(PixelTrace, SamplesAreHalfFromEachOfTwoStreams) {
  RenderSettings settings = Settings("whitted", 40, 8);
  settings.trace.shadow_samples = 1;
  settings.budget.error = ErrorTarget{1e-4};
  settings.budget.adaptive = Adaptive::off;
  const Traced traced("area_light.scn", settings);
  const R2::Image image = Render(traced.stage.world, *traced.accelerator, settings).image;
  for (int column = 0; column < 40; column += 3) {
    constexpr double float_rounding = 1e-6;
    const double shown = image.At(column, 12).r;
    EXPECT_NEAR(traced.Pixel(column, 12).Mean().r, shown, float_rounding * (1 + shown)) << column;
  }
}

TEST(PixelTrace, ClampedSamplesCountAsInTheImage) {
  RenderSettings settings = Settings("whitted", 1, 4);
  settings.trace.sampler = SamplerKind::grid;
  settings.clamp = Clamp::samples;
  const project::Stage stage(
      project::FromText("camera 0 0 5  0 0 -1  0 1 0  0.5  0.01 100 dir_light 0 0 0 0 0 -1 "
                        "material 0 0 0  0 0 0  0 0 0  0 0 0  4 4 .5  10 1 0 box 0  0 -9 0  9 9 1"));
  const auto accelerator = FindAcceleratorKind("bvh")->Make(stage.world, {});
  EXPECT_EQ(PixelTracer(stage.world, *accelerator, settings).Trace(0, 0, 4).Mean(), (R2::Color{0.5, 0.5, 0.25}));
  const std::string tree = DebugPixel(stage.world, *accelerator, settings, 0, 0);
  EXPECT_NE(tree.find(": 4 4 0.5, clamped to 1 1 0.5\n"), std::string::npos) << tree;
  EXPECT_NE(tree.find(": 0 0 0\n"), std::string::npos) << tree;
}

// Camera rays are traced together, and then points of triangles have no texture coordinates unless the material needs
// them.
TEST(DebugPixel, WritesAllDigitsOnRequest) {
  const project::Stage stage(project::FromText("camera 0 0 0  0 0 -1  0 1 0  .39269908169872414 .01 100\n"));
  const auto accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
  RenderSettings settings = project::Sized(512);
  const double x = std::tan(std::numbers::pi / 8) / 512;  // of the pixel to the right of the middle
  EXPECT_NE(DebugPixel(stage.world, *accelerator, settings, 256, 256, Digits::all).find("along " + ToText(x) + " "),
            std::string::npos);
  EXPECT_EQ(DebugPixel(stage.world, *accelerator, settings, 256, 256).find(ToText(x)), std::string::npos);
}

TEST(PixelTrace, TextureCoordinatesMatchModeUvWithoutATexture) {
  const project::Stage stage(
      project::FromText("camera 0 0 3  0 0 -1  0 1 0  .3 .01 100\n"
                        "material 0 0 0  .5 .5 .5  0 0 0  0 0 0  0 0 0  1 1 0\n"
                        "quad 0  -1 -1 0  1 -1 0  1 1 0  -1 1 0\n"));
  const auto accelerator = FindAcceleratorKind("bvh")->Make(stage.world, {});
  for (const char* mode : {"whitted", "path"}) {
    const PixelTrace uv = PixelTracer(stage.world, *accelerator, Settings("uv", 9)).Trace(6, 5, 1);
    const PixelTrace trace = PixelTracer(stage.world, *accelerator, Settings(mode, 9)).Trace(6, 5, 1);
    ASSERT_TRUE(trace.rays[0].at);
    EXPECT_EQ(trace.rays[0].at->uv.x, uv.radiances[0].r) << mode;
    EXPECT_EQ(trace.rays[0].at->uv.y, uv.radiances[0].g) << mode;
    EXPECT_GT(uv.radiances[0].r * uv.radiances[0].g, 0);
  }
}

TEST(PixelTrace, BlackSamplesOnOutlinesAreReportedAsSuch) {
  RenderSettings settings = Settings("whitted", 60);
  settings.trace.outline.width = 4;
  const Traced traced("hello.scn", settings);
  int outlined = 0;
  for (int column = 0; column < 60; ++column) {
    const PixelTrace trace = traced.Pixel(column, 30);
    const bool is_said = RayTree(trace, traced.stage.world, settings).find("on an outline") != std::string::npos;
    EXPECT_EQ(is_said, trace.rays[0].is_outlined);
    EXPECT_EQ(is_said, trace.radiances[0] == R2::Color{}) << column;
    outlined += is_said;
  }
  EXPECT_GT(outlined, 2);
  EXPECT_LT(outlined, 60);
}

TEST(PixelTrace, CostsAreLabeledAsSuch) {
  for (const char* mode : {"heat", "rays"}) {
    const Traced traced("hello.scn", Settings(mode, 20));
    const std::string tree = DebugPixel(traced.stage.world, *traced.accelerator, traced.settings, 10, 10);
    EXPECT_NE(tree.find(", a cost of rays that contribute light\n"), std::string::npos) << tree;
  }
}

TEST(PixelTrace, RaysStartWhereTheirParentsEnd) {
  const Traced traced("glass.scn", Settings("whitted", 100));
  std::size_t children = 0;
  for (int at = 0; at < 100; ++at)
    for (const PixelTrace trace = traced.Pixel(at, at); const RecordedRay& ray : trace.rays) {
      if (ray.parent == RecordedRay::none) continue;
      const RecordedRay& parent = trace.rays[static_cast<std::size_t>(ray.parent)];
      ASSERT_LT(ray.parent, &ray - trace.rays.data());
      ASSERT_TRUE(parent.at);
      // Rays that pass straight through keep their parent's origin and start at its hit.
      const R3::Point start = ray.ray.At(ray.ray.t_min);
      EXPECT_LT(Length(start - parent.at->position), 1e-9 * (1 + Length(ray.ray.origin - R3::Point{})));
      ++children;
    }
  EXPECT_GT(children, 50u);
}

TEST(PixelTrace, HitsAreThoseOfTheAccelerator) {
  const Traced traced("hello.scn", Settings("whitted", 60));
  const auto none = FindAcceleratorKind("none")->Make(traced.stage.world, {});
  Workspace workspace;
  std::size_t stopped = 0;
  for (int at = 0; at < 60; at += 3)
    for (const PixelTrace trace = traced.Pixel(at, 59 - at); const RecordedRay& ray : trace.rays) {
      const auto hit = none->Intersect(ray.ray, workspace);
      ASSERT_EQ(hit.has_value(), ray.hit.has_value());
      if (!hit) continue;
      EXPECT_EQ(hit->t, ray.hit->t);
      EXPECT_EQ(hit->instance, ray.hit->instance);
      stopped += ray.kind == RayKind::shadow;
    }
  EXPECT_GT(stopped, 0u);
}

TEST(PixelTrace, TheTreeShowsEveryRayAndItsEnd) {
  project::Stage stage(
      project::FromText("background 0.5 0.25 0.125\nambient 0 0 0\n"
                        "camera 0 0 5  0 0 -1  0 1 0  0.3  0.01 100\n"
                        "point_light 1 1 1  0 0 5  1 0 0\n"
                        "material 0 0 0  0.5 0.5 0.5  0.25 0.25 0.25  0 0 0  0 0 0  1 1 0\n"
                        "sphere 0  0 0 0  1\n"));
  RenderSettings settings = Settings("whitted", 3);
  const auto accelerator = FindAcceleratorKind("bvh")->Make(stage.world, {});
  const std::string middle = DebugPixel(stage.world, *accelerator, settings, 1, 1);
  EXPECT_EQ(middle.find("pixel 1 1 of 3 x 3, whitted: "), 0u) << middle;
  // Straight on: the light is at the eye, so kd + ks arrive, and ks of the background in the mirror.
  EXPECT_NE(middle.find("at t 4, 0 0 1, normal 0 0 1"), std::string::npos) << middle;
  EXPECT_NE(middle.find("  shadow ray to light 1, point light at 0 0 5, color 1 1 1\n"), std::string::npos) << middle;
  EXPECT_NE(middle.find("unoccluded, contributes 0.75 0.75 0.75\n"), std::string::npos) << middle;
  EXPECT_NE(middle.find("hits nothing, contributes 0.125 0.0625 0.03125\n"), std::string::npos) << middle;
  const std::string corner = DebugPixel(stage.world, *accelerator, settings, 0, 0);
  EXPECT_NE(corner.find("hits nothing, contributes 0.5 0.25 0.125\n"), std::string::npos) << corner;
}

TEST(PixelTrace, ALongTreeIsTruncatedWithANote) {
  const Traced traced("area_light.scn", Settings("whitted", 20, 4));
  const PixelTrace trace = traced.Pixel(10, 5);
  ASSERT_GT(trace.rays.size(), 12u);
  const std::string tree = RayTree(trace, traced.stage.world, traced.settings, 10);
  EXPECT_NE(tree.find(std::to_string(trace.rays.size() - 10) + " more rays are not shown"), std::string::npos) << tree;
}

}  // namespace
}  // namespace ray
