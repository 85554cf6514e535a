#include "source/render/Render.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

#include "tests/Named.h"
#include "tests/Project.h"

namespace ray {
namespace {

RenderSettings Small() {
  RenderSettings settings = project::Sized(45, 31);
  settings.samples = 6;
  settings.threads = 2;
  return settings;
}

// A viewer renders an image row by row with one integrator; it must equal raypro's.
TEST(Render, PartsWithASharedIntegratorEqualTheWhole) {
  const project::Stage stage(project::Root() / "scenes" / "many_lights.scn");
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  RenderSettings settings = Small();
  settings.mode = RenderMode::path;
  const auto integrator = IntegratorOf(stage.world, *accelerator, settings);
  const R2::Image whole = Render(stage.world, *accelerator, settings).image;
  int wrong = 0;
  for (int bottom = 0; bottom < settings.height; bottom += 5) {
    settings.crop = {3, bottom, 40, std::min(settings.height, bottom + 5)};
    const R2::Image part = Render(stage.world, *integrator, settings).image;
    for (int y = 0; y < part.Height(); ++y)
      for (int x = 0; x < part.Width(); ++x) wrong += !(part.At(x, y) == whole.At(3 + x, bottom + y));
  }
  EXPECT_EQ(wrong, 0);
}

// A thread that waited for such work once started another tile, and then waited for itself.
TEST(Render, ACallbackMayWorkOnManyThreads) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  RenderSettings settings = Small();
  settings.tile_size = Film::block_side;
  settings.threads = 4;
  settings.samples = 1;
  constexpr int renders = 50, pieces = 64;
  std::atomic<int> done{0};
  RenderMonitor monitor;
  monitor.tile_done = [&](const RenderProgress&) {
    tbb::parallel_for(0, pieces, [&](int) { ++done; });
  };
  for (int i = 0; i < renders; ++i) Render(stage.world, *accelerator, settings, monitor);
  EXPECT_GE(done, renders * pieces);
}

const std::string from_the_middle = "camera 0 0 0 1 2 3 0 1 0 .5 1 10\n", box_around = "box 0 -9 -9 -9 9 9 9";

/// Renders between mirrors all around that reflect a half, with the limits of the settings.
double ShareCutBetweenMirrors(const RenderSettings& settings) {
  const project::Stage stage(
      project::FromText(from_the_middle + "material 0 0 0 0 0 0 .5 .5 .5 0 0 0 0 0 0 1 1 0\n" + box_around));
  return project::Render(stage, settings).share_cut;
}

TEST(Render, TheCutShareIsTheLightOfLongerPaths) {
  constexpr double rounding = 1 / RayCounts::throughput_unit;
  RenderSettings settings = Small();
  settings.trace.min_luminance = 0;
  for (const RenderMode mode : {RenderMode::whitted, RenderMode::path}) {
    settings.mode = mode;
    settings.trace.max_depth = 0;
    EXPECT_NEAR(ShareCutBetweenMirrors(settings), 0.5, rounding);
    settings.trace.max_depth = 2;
    EXPECT_NEAR(ShareCutBetweenMirrors(settings), 0.125, rounding);
    settings.filter = FilterKind::gaussian;
    EXPECT_NEAR(ShareCutBetweenMirrors(settings), 0.125, rounding) << "with a margin of samples";
    settings.trace.outline.width = 1;
    EXPECT_NEAR(ShareCutBetweenMirrors(settings), 0.125, rounding) << "with rays that look for outlines";
  }
  settings.mode = RenderMode::whitted;
  settings.trace.max_depth = 100;
  settings.trace.min_luminance = 0.1;
  EXPECT_NEAR(ShareCutBetweenMirrors(settings), 0.0625, rounding) << "the first below 0.1";
}

TEST(Render, NothingIsCutIfEveryPathEndsByItself) {
  const project::Stage stage(
      project::FromText(from_the_middle + "material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0\n" + box_around));
  EXPECT_EQ(project::Render(stage, Small()).share_cut, 0);
}

TEST(Render, PassesThatAreShownChangeNoBit) {
  const project::Stage stage(project::Root() / "scenes" / "area_light.scn");
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  for (const std::string filter : {"box", "gaussian"}) {
    RenderSettings settings = Small();
    settings.filter = project::Named{filter};
    RenderMonitor monitor;
    std::vector<std::uint32_t> samples;
    std::vector<R2::Image> images;
    monitor.pass_done = [&](const R2::Image& image, std::uint32_t count) {
      samples.push_back(count);
      images.push_back(image);
    };
    const RenderResult seen = Render(stage.world, *accelerator, settings, monitor);
    EXPECT_EQ(samples, (std::vector<std::uint32_t>{1, 2, 4}));
    EXPECT_TRUE(seen.image == Render(stage.world, *accelerator, settings).image) << filter;
    ASSERT_EQ(images.size(), 3u);
    EXPECT_FALSE(images[0] == images[1]);
    EXPECT_EQ(images[2].Width(), settings.width);
    // A render that stopped after the pass would have given the same.
    settings.replay = Replay{false, 6, {4}, {}, {}};
    EXPECT_TRUE(images[2] == Render(stage.world, *accelerator, settings).image) << filter;
  }
}

/// A render stopped after that many tiles, and its state.
struct Broken {
  RenderResult result;
  RenderState state;
};

Broken BreakOff(const World& world, const Accelerator& accelerator, RenderSettings settings, int tiles) {
  std::atomic<bool> stop = false;
  Broken broken;
  RenderMonitor monitor;
  monitor.stop = &stop;
  monitor.tile_done = [&](const RenderProgress&) {
    if (--tiles == 0) stop = true;
  };
  monitor.save = [&](const RenderState& state) { broken.state = state; };
  settings.threads = 1;
  settings.tile_size = 16;
  broken.result = Render(world, accelerator, settings, monitor);
  return broken;
}

// A report requires an error after each pass; that error must not decide when the render ends.
TEST(Render, PassReportsDoNotChangeErrorTargetedImages) {
  const project::Stage stage(project::Root() / "scenes" / "indirect.scn");
  RenderSettings settings = Small();
  settings.samples = 64;
  settings.mode = RenderMode::path;
  for (const double target : {8.0, 5.0, 4.0, 3.0, 2.0})
    for (settings.seed = 1; settings.seed <= 6; ++settings.seed) {
      settings.budget.error = ErrorTarget{target, ErrorUnit::display};
      settings.wants_passes = false;
      const RenderResult without = project::Render(stage, settings);
      settings.wants_passes = true;
      const RenderResult with = project::Render(stage, settings);
      EXPECT_EQ(with.samples.mean, without.samples.mean) << target << " seed " << settings.seed;
      EXPECT_TRUE(with.image == without.image) << target << " seed " << settings.seed;
    }
}

// Four samples take four passes, plus one for the look before them, of 12 tiles each.
TEST(Render, AnInterruptedImageIsWholeAfterTheFirstLook) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  RenderSettings settings = project::Sized(60, 44);
  settings.samples = 4;
  const R2::Image whole = Render(stage.world, *accelerator, settings).image;
  const auto mean_difference = [&](const R2::Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < whole.Channels().size(); ++i)
      sum += std::abs(std::clamp(image.Channels()[i], 0.f, 1.f) - std::clamp(whole.Channels()[i], 0.f, 1.f));
    return sum / static_cast<double>(whole.Channels().size());
  };
  const double of_black = mean_difference(R2::Image(settings.width, settings.height));
  for (int tiles = 12; tiles < 4 * 12; tiles += 5) {
    const Broken broken = BreakOff(stage.world, *accelerator, settings, tiles);
    ASSERT_EQ(broken.result.stop, Stop::request) << tiles;
    EXPECT_LT(mean_difference(broken.result.image), 0.25 * of_black) << tiles;
    EXPECT_GT(broken.result.pixels_done, 0);
  }
}

TEST(Render, EndingInTheFirstSampleIsRepeatedByAReplay) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  for (const FilterKind filter : {FilterKind::box, FilterKind::gaussian}) {
    RenderSettings settings = project::Sized(60, 44);
    settings.filter = filter;
    settings.samples = 4;
    const RenderResult broken = BreakOff(stage.world, *accelerator, settings, 17).result;
    ASSERT_LT(broken.samples.mean, 1);
    ASSERT_EQ(*std::ranges::min_element(broken.block_samples), 0u);
    settings.replay = Replay{false, 4, {1}, broken.block_samples, broken.block_places};
    const RenderResult again = Render(stage.world, *accelerator, settings);
    EXPECT_TRUE(again.image == broken.image);
    EXPECT_EQ(again.block_places, broken.block_places);
  }
}

/// Requests a stop when its `last` radiances are computed.
class Stopper : public Integrator {
 public:
  Stopper(int last, std::atomic<bool>& stop) : last_(last), stop_(stop) {}
  int Asked() const { return asked_; }

 private:
  void Li(std::span<const CameraSample>, std::span<R2::Color>, TraceState&) const override {
    if (++asked_ == last_) stop_ = true;
  }
  const int last_;
  std::atomic<bool>& stop_;
  mutable std::atomic<int> asked_ = 0;
};

TEST(Render, LooksCutShortByTimeAreSpreadOverTheImage) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  RenderSettings settings = project::Sized(2048);
  settings.budget.seconds = 1e-9;
  settings.tile_size = 16;  // so that a tile which a thread has just started does not count
  constexpr int blocks = 2048 / BlockOrder::side, parts = 4;  // across the image
  for (const int threads : {1, 2}) {
    settings.threads = threads;
    const RenderResult result = Render(stage.world, *accelerator, settings);
    EXPECT_EQ(result.stop, Stop::time);
    std::array<int, parts * parts> looks{};
    for (std::size_t i = 0; i < result.block_places.size(); ++i)
      looks[i / blocks * parts / blocks * parts + i % blocks * parts / blocks] += result.block_places[i];
    EXPECT_GE(std::accumulate(looks.begin(), looks.end(), 0), 512);
    EXPECT_LT(std::accumulate(looks.begin(), looks.end(), 0), blocks * blocks / 2);
    EXPECT_GT(*std::ranges::min_element(looks), 0);
  }
}

TEST(Render, BeginsNoRaysAfterAStopRequest) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  for (const int threads : {1, 3}) {
    for (const int last : {1, 5, 40}) {
      RenderSettings settings = Small();
      settings.threads = threads;
      std::atomic<bool> stop = false;
      const Stopper stopper(last, stop);
      RenderMonitor monitor;
      monitor.stop = &stop;
      EXPECT_EQ(Render(stage.world, stopper, settings, monitor).stop, Stop::request);
      EXPECT_GE(stopper.Asked(), last);
      // The other threads may each have checked just before.
      EXPECT_LE(stopper.Asked(), last + threads - 1);
    }
  }
}

}  // namespace
}  // namespace ray
