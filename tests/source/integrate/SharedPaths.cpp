// Sharing light changes no mean, and no group's sum where all surfaces are alike.
#include "source/integrate/SharedPaths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "source/integrate/Path.h"
#include "source/render/RenderBlock.h"
#include "tests/Project.h"

namespace ray {
namespace {

RenderSettings PathsOf(int size, int per_pixel, bool shares_light) {
  RenderSettings settings = project::Sized(size);
  settings.mode = RenderMode::path;
  settings.samples = per_pixel;
  settings.trace.max_depth = 4;
  settings.shares_light = shares_light;
  return settings;
}

TEST(SharedPaths, AFurnaceKeepsItsSumExactly) {
  // In a closed hollow that reflects half and emits 1, each path that scatters six times finds 2 - 2^-6.
  const project::Stage stage(
      project::FromText("camera 0 0 0  0 0 -1  0 1 0  0.7  0.01 100 "
                        "material 0 0 0  0.5 0.5 0.5  0 0 0  0 0 0  1 1 1  1 1 0  box 0  -1 -1 -1  1 1 1"));
  TraceSettings trace;
  trace.max_depth = 5, trace.strategy = LightStrategy::bsdf, trace.roulette = Roulette::off;
  const auto accelerator = FindAcceleratorKind("bvh")->Make(stage.world, {});
  const Path path(stage.world, *accelerator, trace);
  constexpr int side = 16;
  const CameraRays camera(stage.scene->camera, {}, false, side, side, trace.sampler, 2);
  std::vector<CameraSample> seen;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) seen.push_back(camera({x, y, PixelKey(RandomKey(1), x, y, 0), 1}));
  SharedPaths shared;
  shared.Begin(seen.size(), RandomKey(7));
  TraceState state;
  state.shared = &shared;
  std::vector<R2::Color> radiances(seen.size());
  path.Li(seen, radiances, state);
  std::vector<R2::Color> alone = radiances;
  shared.GiveBack(alone);
  path.AddShared(radiances, state);
  const double light = 2 - std::pow(2, -6);
  double sum = 0;
  int changed = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_NEAR(alone[i].r, light, 1e-12);
    sum += radiances[i].r;
    changed += std::abs(radiances[i].r - alone[i].r) > 1e-3;
  }
  EXPECT_NEAR(sum / static_cast<double>(seen.size()), light, 1e-12);
  EXPECT_GT(changed, side * side / 2);
}

/// Compares means of blocks with and without sharing, over independent renders, in standard errors.
void ExpectEqualMeans(const std::string& scene) {
  const project::Stage stage(project::FromText(scene));
  constexpr int size = 40, block = 8, seeds = 12, per_pixel = 16;
  constexpr std::size_t blocks = (size / block) * (size / block);
  std::array<std::vector<double>, blocks> differences;
  for (int seed = 0; seed < seeds; ++seed) {
    R2::Image images[2];
    for (const bool shares : {false, true}) {
      RenderSettings settings = PathsOf(size, per_pixel, shares);
      settings.seed = static_cast<std::uint64_t>(2 * seed + shares);
      images[shares] = project::Render(stage, settings).image;
    }
    for (std::size_t b = 0; b < blocks; ++b) {
      double difference = 0;
      for (int i = 0; i < block * block; ++i) {
        const int x = static_cast<int>(b) % (size / block) * block + i % block;
        const int y = static_cast<int>(b) / (size / block) * block + i / block;
        const R2::Color alone = images[0].At(x, y), shared = images[1].At(x, y);
        difference += (shared.r + shared.g + 2 * shared.b - alone.r - alone.g - 2 * alone.b) / (block * block);
      }
      differences[b].push_back(difference);
    }
  }
  double sum_of_squares = 0;
  int noisy = 0;
  for (const std::vector<double>& of_block : differences) {
    const double mean = std::accumulate(of_block.begin(), of_block.end(), 0.0) / seeds;
    double variance = 0;
    for (const double d : of_block) variance += (d - mean) * (d - mean) / (seeds - 1);
    if (variance == 0 && mean == 0) continue;  // it sees the background alone
    ++noisy;
    const double z = mean / std::sqrt(variance / seeds);
    EXPECT_LT(std::abs(z), 5) << "a difference of " << mean;  // Student's t of 11 degrees: 1 in 2500
    sum_of_squares += z * z;
  }
  EXPECT_GT(noisy, static_cast<int>(blocks / 2));
  EXPECT_LT(sum_of_squares / noisy, 2.2);  // 1.22 expected
}

TEST(SharedPaths, MeansStayTheSameInARoomOfPureColors) {
  ExpectEqualMeans(
      "camera 0 1 3.9  0 0 -1  0 1 0  0.4  0.01 100 "
      "material 0 0 0  .7 .7 .7  0 0 0  0 0 0  0 0 0  1 1 0  material 0 0 0  .8 0 0  0 0 0  0 0 0  0 0 0  1 1 0 "
      "material 0 0 0  0 .6 .6  0 0 0  0 0 0  0 0 0  1 1 0  material 0 0 0  0 0 0  0 0 0  0 0 0  20 19 17  1 1 0 "
      "quad 0  -1 0 4  1 0 4  1 0 -1  -1 0 -1  quad 0  -1 2 4  -1 2 -1  1 2 -1  1 2 4 "
      "quad 0  -1 0 -1  1 0 -1  1 2 -1  -1 2 -1  quad 1  -1 0 4  -1 0 -1  -1 2 -1  -1 2 4 "
      "quad 2  1 0 -1  1 0 4  1 2 4  1 2 -1  box 0  -.6 0 -.6  -.05 1.2 -.1  sphere 3  0 1.7 0  .15");
}

TEST(SharedPaths, MeansStayTheSameWithGlassMirrorsAndHighlights) {
  ExpectEqualMeans(
      "camera 0 1 3.9  0 0 -1  0 1 0  0.4  0.01 100  background .1 .2 .3 "
      "material 0 0 0  .7 .7 .7  0 0 0  0 0 0  0 0 0  1 1 0  material 0 0 0  .2 .1 .1  .5 .5 .5  0 0 0  0 0 0  20 1 0 "
      "material 0 0 0  0 0 0  .1 .1 .1  .8 .8 .8  0 0 0  50 1.5 0  material 0 0 0  .3 0 0  0 0 0  0 0 0  4 4 3  1 1 0 "
      "material 0 0 0  0 0 0  .9 .9 .9  0 0 0  0 0 0  50 1 0 "
      "quad 0  -1 0 4  1 0 4  1 0 -1  -1 0 -1  quad 0  -1 0 -1  1 0 -1  1 2 -1  -1 2 -1 "
      "quad 1  -1 0 4  -1 0 -1  -1 2 -1  -1 2 4  quad 4  1 0 -1  1 0 4  1 2 4  1 2 -1 "
      "sphere 2  -.3 .4 0  .4  sphere 0  .4 .4 .3  .4  sphere 3  0 1.5 0  .3");
}

TEST(SharedPaths, WhatMovesSharesNothing) {
  const project::Stage stage(ray::Parse(project::Root() / "scenes/motion.scn", {}).scene);
  ASSERT_TRUE(stage.world.Moves());
  const R2::Image shared = project::Render(stage, PathsOf(40, 3, true)).image;
  EXPECT_TRUE(shared == project::Render(stage, PathsOf(40, 3, false)).image);
}

}  // namespace
}  // namespace ray
