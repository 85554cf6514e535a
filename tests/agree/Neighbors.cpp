// One sample where neighboring pixels are similar and all where they differ give the image of all samples everywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "R2/ImageFile.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/SceneSettings.h"
#include "source/text/EnumNames.h"
#include "tests/Project.h"

namespace {

constexpr int side = 160, samples = 9;

/// Returns the settings of the scene, except for image size and samples.
ray::RenderSettings SettingsOf(const ray::Scene& scene, ray::SamplerKind sampler) {
  const ray::RenderOptions typed = ray::ReadCommandLine(
      ray::Program::raypro,
      std::vector<std::string>{"a.scn", "b.pfm", "-width", std::to_string(side), "-height", std::to_string(side),
                               "-samples", std::to_string(samples), "-sampler", NameOf(sampler)});
  return WithSettingsOf(scene, typed).render;
}

/// Returns the share of pixels that are more than a level off in any channel.
double ShareOff(const R2::Image& a, const R2::Image& b) {
  int off = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto levels = [](double v) { return static_cast<int>(R2::ToByte(v, R2::Quantization::rounded)); };
      const R2::Color p = a.At(x, y), q = b.At(x, y);
      off += std::max({std::abs(levels(p.r) - levels(q.r)), std::abs(levels(p.g) - levels(q.g)),
                       std::abs(levels(p.b) - levels(q.b))}) > 1;
    }
  return off / double{side * side};
}

TEST(AdaptiveNeighbors, SavesRaysAndChangesFewPixelsVisibly) {
  for (const char* name :
       {"first.scn", "texture.scn", "specular.scn", "torus.scn", "refraction.scn", "transform.scn", "mirrors.json"})
    for (const auto sampler : {ray::SamplerKind::rotated_grid, ray::SamplerKind::sobol}) {
      const project::Stage stage(ray::Parse((project::Root() / "scenes" / name).string(), {}).scene);
      ray::RenderSettings settings = SettingsOf(*stage.scene, sampler);
      const ray::RenderResult full = project::Render(stage, settings);
      settings.budget.adaptive = ray::Adaptive::neighbors;
      const ray::RenderResult adaptive = project::Render(stage, settings);
      EXPECT_LE(ShareOff(full.image, adaptive.image), 0.001) << name << ' ' << NameOf(sampler);
      EXPECT_LT(adaptive.rays.Total(), full.rays.Total()) << name;
      EXPECT_EQ(adaptive.samples.least, 1u) << name;
      EXPECT_EQ(adaptive.samples.most, static_cast<std::uint32_t>(samples)) << name;
    }
}

TEST(AdaptiveNeighbors, FullySamplesBlocksOnBothSidesOfAnEdge) {
  // White from the middle to the right, where a block of 8 x 8 begins: the black block next to it differs from it.
  const project::Stage stage(
      project::FromText("camera 0 0 1  0 0 -1  0 1 0  .7853981633974483  .01 100 background 0 0 0 ambient 1 1 1 "
                        "material 1 1 1  0 0 0  0 0 0  0 0 0  0 0 0  1 1 0 dir_light 0 0 0  0 -1 0 "
                        "tri 0  0 -9 0  9 -9 0  0 9 0 tri 0  9 -9 0  9 9 0  0 9 0"));
  ray::RenderSettings settings = project::Sized(64);
  settings.samples = 4;
  settings.budget.adaptive = ray::Adaptive::neighbors;
  const ray::RenderResult result = project::Render(stage, settings);
  for (std::size_t block = 0; block < result.block_samples.size(); ++block)
    EXPECT_EQ(result.block_samples[block], block % 8 == 3 || block % 8 == 4 ? 4u : 1u) << block;
}

TEST(AdaptiveNeighbors, IsTheSameImageForAnyThreadsAndTiles) {
  const project::Stage stage(ray::Parse((project::Root() / "scenes/first.scn").string(), {}).scene);
  ray::RenderSettings settings = SettingsOf(*stage.scene, ray::SamplerKind::grid);
  settings.budget.adaptive = ray::Adaptive::neighbors;
  settings.threads = 1;
  const auto wanted = project::Render(stage, settings).image.Channels();
  settings.threads = 3;
  settings.tile_size = 8;
  EXPECT_TRUE(project::Render(stage, settings).image.Channels() == wanted);
}

}  // namespace
