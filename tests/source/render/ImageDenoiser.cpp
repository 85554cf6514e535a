#include "source/render/ImageDenoiser.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>

#include "source/film/denoise/OpenImageDenoise.h"
#include "source/film/error/ImageError.h"
#include "source/render/GatherGuides.h"
#include "source/render/Schedule.h"
#include "tests/Project.h"

namespace ray {
namespace {

RenderSettings Indirect(int samples) {
  RenderSettings settings = project::Sized(64);
  settings.samples = samples;
  settings.mode = RenderMode::path;
  settings.trace.max_depth = 4;
  return settings;
}

project::Stage Room() { return project::Stage(project::Root() / "scenes" / "indirect.scn"); }

TEST(ImageDenoiser, MoreThanHalvesTheErrorOfIndirectLightAsClaimed) {
  const project::Stage stage = Room();
  std::vector<R2::Image> references;
  for (const std::uint64_t seed : {4711, 4712}) {
    RenderSettings many = Indirect(256);
    many.seed = seed;
    references.push_back(project::Render(stage, many).image);
  }
  // sums of squares; a single estimate of so small an image is left to chance
  double before = 0, claimed = 0, truth = 0;
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

TEST(ImageDenoiser, NoBitDependsOnThreadsOrTiles) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  RenderSettings settings = project::Sized(45, 31);
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

TEST(ImageDenoiser, WithoutDenoisingThereIsOneStreamAndNoFilter) {
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(4);
  const RenderResult plain = project::Render(stage, settings);
  EXPECT_FALSE(plain.error_before_denoising || plain.two_streams);
  settings.denoise = true;
  EXPECT_TRUE(HasTwoStreams(settings));
  EXPECT_GT(project::Render(stage, settings).rays[RayKind::camera].rays, plain.rays[RayKind::camera].rays);
}

TEST(ImageDenoiser, AFailingLibraryLeavesTheImageAndIsReported) {
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

TEST(ImageDenoiser, WorksWithCropsFiltersAndUnevenSampleCounts) {
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(64);
  settings.denoise = true;
  settings.crop = {5, 9, 50, 40};
  settings.filter = FilterKind::gaussian;
  settings.budget.error = ErrorTarget{0.8, ErrorUnit::display};
  const RenderResult result = project::Render(stage, settings);
  EXPECT_EQ(result.image.Width(), 45);
  EXPECT_LT(result.samples.least, result.samples.most);
  ASSERT_TRUE(result.error && result.error_before_denoising);
  EXPECT_LT(result.error->estimate, result.error_before_denoising->estimate);
}

/// Returns true if a crop has the pixels of the whole.
::testing::AssertionResult IsPart(const R2::Image& part, const PixelRectangle& crop, const R2::Image& whole) {
  if (part.Width() != crop.Width() || part.Height() != crop.Height()) return ::testing::AssertionFailure() << "size";
  for (int y = 0; y < part.Height(); ++y)
    for (int x = 0; x < part.Width(); ++x)
      if (!(part.At(x, y) == whole.At(crop.x0 + x, crop.y0 + y)))
        return ::testing::AssertionFailure() << "differs at " << crop.x0 + x << ' ' << crop.y0 + y;
  return ::testing::AssertionSuccess();
}

// The surroundings on which its pixels depend are rendered as well, including edges and textures, mirrors and wide
// filters.
TEST(ImageDenoiser, ACropHasThePixelsOfTheWhole) {
  for (const char* scene : {"hello", "indirect", "glossy"})
    for (const FilterKind filter : {FilterKind::box, FilterKind::mitchell}) {
      const project::Stage stage(project::Root() / "scenes" / (std::string(scene) + ".scn"));
      RenderSettings settings = project::Sized(90, 61);
      settings.samples = 4;
      settings.mode = filter == FilterKind::box ? RenderMode::path : RenderMode::whitted;
      settings.filter = filter;
      settings.denoise = true;
      const RenderResult whole = project::Render(stage, settings);
      EXPECT_FALSE(whole.denoised_by.empty());
      for (const PixelRectangle& crop : {PixelRectangle{0, 0, 1, 1},
                                         {45, 30, 46, 31},
                                         {89, 60, 90, 61},
                                         {17, 9, 40, 33},
                                         {0, 0, 90, 20},
                                         {60, 0, 90, 61},
                                         {0, 0, 90, 61}}) {
        settings.crop = crop;
        EXPECT_TRUE(IsPart(project::Render(stage, settings).image, crop, whole.image)) << scene;
      }
    }
}

// Squared errors are means over pixels, so those of parts have the whole image's as their mean. The bias of a denoised
// image is estimated for all pixels together, which changes half a percent here.
TEST(ImageDenoiser, ErrorsOfPartsAddUpToTheWhole) {
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(2);
  settings.denoise = true;
  const RenderResult whole = project::Render(stage, settings);
  double before = 0, left = 0;
  for (const PixelRectangle& part : {PixelRectangle{0, 0, 24, 64}, {24, 0, 64, 32}, {24, 32, 64, 64}}) {
    settings.crop = part;
    const RenderResult made = project::Render(stage, settings);
    before += static_cast<double>(part.Area()) * std::pow(made.error_before_denoising->estimate, 2);
    left += static_cast<double>(part.Area()) * std::pow(made.error->estimate, 2);
  }
  EXPECT_NEAR(std::sqrt(before / (64 * 64)) / whole.error_before_denoising->estimate, 1, 1e-6);
  EXPECT_NEAR(std::sqrt(left / (64 * 64)) / whole.error->estimate, 1, 0.02);
}

// There is noise around the crop, in the pixels that are rendered for its sake.
TEST(ImageDenoiser, ACropsErrorCountsItsOwnPixelsAlone) {
  const project::Stage stage(project::FromText(
      "camera 0 2 6  0 -.3 -1  0 1 0  .5  .1 100 background .2 .3 .4 area_light 1 1 1  0 4 1  0 -1 0  1  1 0 0 "
      "material 0 0 0  .8 .8 .8  0 0 0  0 0 0  0 0 0  1 1 0 box 0  -4 -.1 -4  4 0 4 sphere 0  0 .8 0  .8"));
  RenderSettings settings = project::Sized(48);
  settings.samples = 4;
  settings.trace.shadow_samples = 1;
  settings.denoise = true;
  EXPECT_GT(project::Render(stage, settings).error->estimate, 0);
  settings.crop = PixelRectangle{0, 44, 48, 48};  // only background
  const RenderResult part = project::Render(stage, settings);
  EXPECT_EQ(part.error->estimate, 0);
  EXPECT_EQ(part.error_before_denoising->estimate, 0);
  EXPECT_EQ(part.pixels_total, 4 * 48);
}

TEST(ImageDenoiser, OnlyDenoisedCropsHaveSurroundings) {
  RenderSettings settings = Indirect(4);
  settings.denoise = true;
  settings.crop = PixelRectangle{20, 20, 30, 30};
  EXPECT_EQ(EmptyFilmOf(settings).Sampled(), (PixelRectangle{4, 4, 46, 46}));
  EXPECT_EQ(MadeRegionOf(settings), (PixelRectangle{4, 4, 46, 46}));
  settings.denoise = false;
  EXPECT_EQ(EmptyFilmOf(settings).Sampled(), *settings.crop);
}

// Glass next to glass: 128 rays of each pixel, each a tree of reflections, took twenty times as long as the image.
TEST(ImageDenoiser, RefiningGuidesTakesAtMostSixRaysPerCameraRay) {
  for (const char* scene : {"glass", "hello", "glossy", "indirect", "refraction", "lens"})
    for (const RenderMode mode : {RenderMode::whitted, RenderMode::path})
      for (const int samples : {2, 16}) {
        const project::Stage stage(project::Root() / "scenes" / (std::string(scene) + ".scn"));
        RenderSettings settings = project::Sized(48);
        settings.samples = samples;
        settings.mode = mode;
        settings.denoise = true;
        settings.trace.fresnel = settings.trace.glossy = true;
        settings.trace.max_depth = 12;
        settings.trace.shadow_samples = 1;
        const RenderResult result = project::Render(stage, settings);
        // Without refinement, a replay's guide rays are only those over camera rays.
        settings.replay = Replay{true, result.planned_samples, {result.passes.back().end}, result.block_samples, {}};
        settings.replay->refinement = Refinement{0};
        const std::uint64_t following = project::Render(stage, settings).guide_rays;
        EXPECT_GT(following, 0u);
        EXPECT_GT(result.guide_rays, following);
        const double camera_rays = 48.0 * 48 * samples;
        EXPECT_LT(static_cast<double>(result.guide_rays - following), 6 * camera_rays)
            << scene << " " << static_cast<int>(mode) << " " << samples;
      }
}

TEST(ImageDenoiser, ReportsEachPhaseToItsEnd) {
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(4);
  settings.denoise = true;
  std::vector<RenderPhase> phases;
  RenderProgress last{};
  RenderMonitor monitor;
  monitor.tile_done = [&](const RenderProgress& now) {
    if (phases.empty() || phases.back() != now.phase) {
      EXPECT_EQ(last.done, last.total);
      phases.push_back(now.phase);
    } else {
      EXPECT_GT(now.done, last.done);
    }
    last = now;
  };
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  Render(stage.world, *accelerator, settings, monitor);
  EXPECT_EQ(phases, (std::vector{RenderPhase::samples, RenderPhase::guides, RenderPhase::filters}));
  EXPECT_EQ(last.done, last.total);
}

TEST(ImageDenoiser, KeepsTheRenderedImageWhenStoppedAndResumesExactly) {
  const project::Stage stage = Room();
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  RenderSettings settings = Indirect(4);
  settings.denoise = true;
  const RenderResult whole = project::Render(stage, settings);
  settings.denoise = false;
  settings.budget.adaptive = Adaptive::off;
  settings.budget.error = ErrorTarget{1e-9, ErrorUnit::display};  // never reached: two streams, as those of -denoise
  const RenderResult plain = project::Render(stage, settings);
  settings = Indirect(4);
  settings.denoise = true;
  for (const RenderPhase phase : {RenderPhase::guides, RenderPhase::filters}) {
    std::atomic<bool> stop = false;
    std::optional<RenderState> kept;
    RenderMonitor monitor;
    monitor.stop = &stop;
    monitor.tile_done = [&](const RenderProgress& now) { stop = stop || now.phase == phase; };
    monitor.save = [&](const RenderState& state) { kept = state; };
    const RenderResult stopped = Render(stage.world, *accelerator, settings, monitor);
    EXPECT_FALSE(stopped.IsComplete() || stopped.error_before_denoising);
    EXPECT_TRUE(stopped.image == plain.image);
    ASSERT_TRUE(kept);
    RenderMonitor again;
    again.resume = [&](const Film&) { return *kept; };
    const RenderResult resumed = Render(stage.world, *accelerator, settings, again);
    EXPECT_TRUE(resumed.image == whole.image);
    EXPECT_EQ(resumed.rays.Total(), whole.rays.Total());
  }
}

// The more rays the render took, the more the guides may take: rays of discarded work must not count.
TEST(ImageDenoiser, ResumedFromAnywhereIsTheSameBitForBit) {
  const project::Stage stage(project::Root() / "scenes" / "glass.scn");
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  RenderSettings settings = project::Sized(40);
  settings.samples = 8;
  settings.denoise = true;
  settings.tile_size = 8;
  const RenderResult whole = project::Render(stage, settings);
  for (const int tiles : {1, 7, 20}) {
    std::atomic<bool> stop = false;
    int done = 0;
    std::optional<RenderState> kept;
    RenderMonitor monitor;
    monitor.stop = &stop;
    monitor.tile_done = [&](const RenderProgress&) { stop = ++done >= tiles; };
    monitor.save = [&](const RenderState& state) { kept = state; };
    Render(stage.world, *accelerator, settings, monitor);
    ASSERT_TRUE(kept);
    RenderMonitor again;
    again.resume = [&](const Film&) { return *kept; };
    const RenderResult resumed = Render(stage.world, *accelerator, settings, again);
    EXPECT_EQ(resumed.rays.Total(), whole.rays.Total());
    EXPECT_TRUE(resumed.image == whole.image);
  }
}

TEST(ImageDenoiser, AStoppedImageIsNotFiltered) {
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

TEST(ImageDenoiser, AReplayOfItsSampleAllocationIsTheSameImage) {
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(16);
  settings.denoise = true;
  const RenderResult first = project::Render(stage, settings);
  settings.replay =
      Replay{first.two_streams, first.planned_samples, {first.passes.back().end}, first.block_samples, {}};
  EXPECT_TRUE(project::Render(stage, settings).image == first.image);
}

TEST(ImageDenoiser, AReplayRefinesGuidesAsRecordedOrIsNotDenoised) {
  const project::Stage stage = Room();
  RenderSettings settings = Indirect(8);
  settings.denoise = true;
  const RenderResult whole = project::Render(stage, settings);
  EXPECT_FALSE(whole.refinement) << "in proportion to the samples";
  Replay replay{whole.two_streams, whole.planned_samples, {whole.passes.back().end}, whole.block_samples, {}};
  replay.refinement = Refinement{0};
  settings.replay = replay;
  const RenderResult unrefined = project::Render(stage, settings);
  EXPECT_LT(unrefined.guide_rays, whole.guide_rays);
  settings.replay->refinement = Refinement{100'000};
  const RenderResult refined = project::Render(stage, settings);
  EXPECT_GT(refined.guide_rays, unrefined.guide_rays);
  EXPECT_LT(static_cast<double>(refined.guide_rays - unrefined.guide_rays), 1.1 * 100'000);
  settings.replay->refinement.reset();
  EXPECT_TRUE(project::Render(stage, settings).image == whole.image);
  settings.replay->denoised = false;
  const RenderResult plain = project::Render(stage, settings);
  EXPECT_FALSE(plain.error_before_denoising || plain.had_no_time_to_denoise);
}

/// Renders the room to a displayed error, denoised.
RenderSettings IndirectToError(double error) {
  RenderSettings settings = Indirect(1);
  settings.denoise = true;
  settings.budget.error = ErrorTarget{error, ErrorUnit::display};
  return settings;
}

TEST(ImageDenoiser, AnErrorTargetIsReachedByTheDenoisedImage) {
  const project::Stage stage = Room();
  RenderSettings settings = IndirectToError(2);
  const RenderResult denoised = project::Render(stage, settings);
  EXPECT_EQ(denoised.stop, Stop::error);
  EXPECT_LE(denoised.error->high, 2);
  EXPECT_EQ(denoised.passes.back().error->high, denoised.error->high) << "passes have the error that decides";
  EXPECT_GT(denoised.error_before_denoising->estimate, 2);
  settings.denoise = false;
  const RenderResult noisy = project::Render(stage, settings);
  EXPECT_GT(noisy.samples.mean, 2 * denoised.samples.mean);
}

// A few pixels at the rim of a lamp hold most of the error, about which the filter is less certain than the samples.
TEST(ImageDenoiser, AnImageThatReachesItsErrorOnlyNoisyStaysNoisy) {
  const project::Stage stage(project::Root() / "bench/scenes/room.scn");
  RenderSettings settings = Indirect(1);
  settings.width = settings.height = 96;
  settings.trace.max_depth = 0;
  settings.denoise = true;
  settings.budget.error = ErrorTarget{3, ErrorUnit::display};
  int noisy = 0;
  for (settings.seed = 7; settings.seed < 30 && noisy == 0; ++settings.seed) {
    const RenderResult result = project::Render(stage, settings);
    ASSERT_EQ(result.stop, Stop::error);
    EXPECT_LE(result.error->high, 3);
    EXPECT_EQ(result.denoised_by.empty(), result.is_better_noisy);
    if (!result.is_better_noisy) continue;
    ++noisy;
    EXPECT_FALSE(result.error_before_denoising);
    RenderSettings again = settings;
    again.replay = Replay{result.two_streams, result.planned_samples, {}, result.block_samples, {}};
    for (const Pass& pass : result.passes) again.replay->ends.push_back(pass.end);
    again.replay->denoised = false, again.replay->looked_at_error = true;
    EXPECT_EQ(project::Render(stage, again).image, result.image);
  }
  EXPECT_EQ(noisy, 1);
}

// Looks between passes must not change the final image.
TEST(ImageDenoiser, AReplayRepeatsAnErrorTargetedImage) {
  const project::Stage stage = Room();
  for (const double target : {8.0, 3.0, 1.5}) {
    RenderSettings settings = IndirectToError(target);
    const RenderResult first = project::Render(stage, settings);
    settings.replay = Replay{first.two_streams, first.planned_samples, {}, first.block_samples, {}};
    for (const Pass& pass : first.passes) settings.replay->ends.push_back(pass.end);
    settings.replay->looked_at_error = true;
    const RenderResult again = project::Render(stage, settings);
    EXPECT_TRUE(again.image == first.image) << target;
    EXPECT_EQ(again.error->high, first.error->high) << target;
    EXPECT_EQ(again.error_before_denoising->high, first.error_before_denoising->high) << target;
    EXPECT_EQ(again.rays.Total(), first.rays.Total()) << target;
  }
}

// For any time of the stop, in samples or in a look with its filters.
TEST(ImageDenoiser, AnErrorTargetIsResumedFromAnywhereBitForBit) {
  const project::Stage stage = Room();
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  const RenderSettings settings = IndirectToError(3);
  const RenderResult whole = Render(stage.world, *accelerator, settings);
  std::optional<RenderState> kept;
  int stops = 0;
  RenderResult last;
  for (int round = 0; round < 100; ++round) {
    std::atomic<bool> stop = false;
    std::thread timer([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(3 * (round + 1)));
      stop = true;
    });
    RenderMonitor monitor;
    monitor.stop = &stop;
    monitor.save = [&](const RenderState& state) { kept = state; };
    if (kept) monitor.resume = [&](const Film&) { return *kept; };
    last = Render(stage.world, *accelerator, settings, monitor);
    timer.join();
    if (last.IsComplete()) break;
    ++stops;
  }
  ASSERT_TRUE(last.IsComplete());
  EXPECT_GT(stops, 2);
  EXPECT_TRUE(last.image == whole.image);
  EXPECT_EQ(last.error->high, whole.error->high);
  EXPECT_EQ(last.error_before_denoising->high, whole.error_before_denoising->high);
  EXPECT_EQ(last.rays.Total(), whole.rays.Total());
}

TEST(ImageDenoiser, WithoutItsLibraryAnErrorTargetIsReachedByTheNoisyImage) {
  if (OpenImageDenoise::IsPresent()) GTEST_SKIP() << "this machine has Open Image Denoise";
  const project::Stage stage = Room();
  RenderSettings settings = IndirectToError(8);
  settings.denoiser = Denoiser::oidn;
  const RenderResult result = project::Render(stage, settings);
  EXPECT_EQ(result.stop, Stop::error);
  EXPECT_FALSE(result.denoise_failure.empty());
  EXPECT_LE(result.error->high, 8);
}

}  // namespace
}  // namespace ray
