#include "source/render/DenoiseResult.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/film/PictureError.h"
#include "source/film/denoise/OpenImageDenoise.h"
#include "source/render/GatherGuides.h"
#include "source/render/Schedule.h"
#include "tests/Project.h"

namespace ray {
namespace {

RenderSettings Indirect(int samples) {
  RenderSettings settings;
  settings.width = settings.height = 64;
  settings.samples = samples;
  settings.mode = RenderMode::path;
  settings.trace.max_depth = 4;
  return settings;
}

project::Stage Room() { return project::Stage(project::Root() / "scenes" / "indirect.scn"); }

TEST(DenoiseResult, TheErrorOfIndirectLightFallsByMoreThanHalfAndSoIsClaimed) {
  const project::Stage stage = Room();
  std::vector<R2::Image> references;
  for (const std::uint64_t seed : {4711, 4712}) {
    RenderSettings many = Indirect(256);
    many.seed = seed;
    references.push_back(project::Render(stage, many).image);
  }
  double before = 0, claimed = 0, truth = 0;  // sums of squares; in a picture as small as this one claim is chance
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    RenderSettings settings = Indirect(16);
    settings.seed = seed;
    settings.denoise = true;
    const RenderResult denoised = project::Render(stage, settings);
    ASSERT_TRUE(denoised.error && denoised.error_before_denoising);
    before += std::pow(denoised.error_before_denoising->estimate, 2);
    claimed += std::pow(denoised.error->estimate, 2);
    truth += std::pow(TrueError(denoised.image, references[0], &references[1], {}), 2);
  }
  EXPECT_LT(truth, 0.25 * before);
  EXPECT_NEAR(std::sqrt(claimed / truth), 1, 0.2);
}

TEST(DenoiseResult, NoBitDependsOnThreadsOrTiles) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  RenderSettings settings;
  settings.width = 45;
  settings.height = 31;
  settings.samples = 6;
  settings.denoise = true;
  settings.threads = 1;
  const RenderResult one = project::Render(stage, settings);
  settings.threads = 3;
  settings.tile_size = 8;
  const RenderResult three = project::Render(stage, settings);
  EXPECT_TRUE(one.image == three.image);
  EXPECT_EQ(one.error->estimate, three.error->estimate);
  EXPECT_EQ(one.rays.Total(), three.rays.Total());
}

TEST(DenoiseResult, WithoutItNothingIsFilteredAndTwoStreamsAreNotTaken) {
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(4);
  const RenderResult plain = project::Render(stage, settings);
  EXPECT_FALSE(plain.error_before_denoising || plain.two_streams);
  settings.denoise = true;
  EXPECT_TRUE(HasTwoStreams(settings));
  EXPECT_GT(project::Render(stage, settings).rays[RayKind::camera].rays, plain.rays[RayKind::camera].rays);
}

TEST(DenoiseResult, WhereALibraryFailsThePictureIsAsItWasRenderedAndTheResultSaysWhy) {
  if (OpenImageDenoise::IsPresent()) GTEST_SKIP() << "this machine has Open Image Denoise";
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(4);
  settings.denoise = true;
  settings.denoiser = Denoiser::oidn;
  const RenderResult result = project::Render(stage, settings);
  EXPECT_NE(result.denoise_failure.find("not installed"), std::string::npos);
  EXPECT_FALSE(result.error_before_denoising);
  settings.denoise = false;
  settings.replay =
      Replay{result.two_streams, result.planned_samples, {result.passes.back().end}, result.block_samples, {}};
  EXPECT_TRUE(project::Render(stage, settings).image == result.image);
}

TEST(DenoiseResult, WorksForACropAFilterAndBlocksOfDifferentSampleCounts) {
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(64);
  settings.denoise = true;
  settings.crop = {5, 9, 50, 40};
  settings.filter = FilterKind::gaussian;
  settings.budget.error = ErrorTarget{2, ErrorUnit::display};
  const RenderResult result = project::Render(stage, settings);
  EXPECT_EQ(result.image.Width(), 45);
  EXPECT_LT(result.samples.least, result.samples.most);
  ASSERT_TRUE(result.error && result.error_before_denoising);
  EXPECT_LT(result.error->estimate, result.error_before_denoising->estimate);
}

TEST(DenoiseResult, APictureThatWasStoppedIsNotFiltered) {
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(16);
  settings.denoise = true;
  const std::atomic<bool> stop = true;
  RenderMonitor monitor;
  monitor.stop = &stop;
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  const RenderResult result = Render(stage.world, *accelerator, settings, monitor);
  EXPECT_FALSE(result.IsComplete());
  EXPECT_FALSE(result.error_before_denoising);
}

TEST(DenoiseResult, AReplayOfItsSampleAllocationIsTheSamePicture) {
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(16);
  settings.denoise = true;
  const RenderResult first = project::Render(stage, settings);
  settings.replay =
      Replay{first.two_streams, first.planned_samples, {first.passes.back().end}, first.block_samples, {}};
  EXPECT_TRUE(project::Render(stage, settings).image == first.image);
}

}  // namespace
}  // namespace ray
