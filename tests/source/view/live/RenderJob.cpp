#include "source/view/live/RenderJob.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <new>
#include <random>
#include <thread>

#include "source/view/live/JobStatus.h"
#include "tests/Folder.h"
#include "tests/Named.h"
#include "tests/Project.h"
#include "tests/source/view/live/Gate.h"

namespace ray {
namespace {

using Clock = std::chrono::steady_clock;
using Order = RenderJob::Order;
using testing::Gated;

double SecondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::shared_ptr<LoadedScene> Loaded(const std::string& name, const AcceleratorSettings& how = {}) {
  return std::make_shared<LoadedScene>(project::Root() / "scenes" / (name + ".scn"), ParseOptions{}, how);
}

RenderSettings Sized(int width, int height) {
  RenderSettings settings = project::Sized(width, height);
  settings.threads = 2;
  return settings;
}

/// Whether it ended before the clock did: a job that hangs fails its test and not the whole suite.
bool Ends(const RenderJob& job) {
  const auto start = Clock::now();
  while (!job.HasEnded() && SecondsSince(start) < 120) std::this_thread::sleep_for(std::chrono::microseconds(100));
  return job.HasEnded();
}

bool Shows(const Frame& frame, const R2::Image& image) {
  std::vector<float> shown;
  frame.Copy(0, frame.Height(), shown);
  return std::ranges::equal(shown, image.Channels());
}

std::array<std::uint64_t, ray_kind_names.size()> RaysByKind(const RayCounts& counts) {
  std::array<std::uint64_t, ray_kind_names.size()> rays{};
  for (std::size_t i = 0; i < rays.size(); ++i) rays[i] = counts.kinds[i].rays;
  return rays;
}

struct Case {
  std::string scene, mode = "whitted";
  int samples = 1;
  std::string filter = "box";
  int width = 37, height = 23, first_places = 1;
  std::string accelerator = "auto";

  RenderSettings Settings() const {
    RenderSettings settings = Sized(width, height);
    settings.mode = project::Named{mode};
    settings.samples = samples;
    settings.filter = project::Named{filter};
    settings.seed = 5;
    return settings;
  }
  std::string Name() const {
    return scene + " " + mode + " " + std::to_string(samples) + " " + filter + " " + std::to_string(width) + "x" +
           std::to_string(height) + " first " + std::to_string(first_places) + " " + accelerator;
  }
};

std::vector<Case> Cases() {
  std::vector<Case> cases;
  for (const std::string scene : {"hello", "area_light", "texture"})
    for (const int samples : {1, 3, 16})
      for (const std::string filter : {"box", "gaussian"}) cases.push_back({scene, "whitted", samples, filter});
  for (const int samples : {1, 3, 16}) cases.push_back({"glass", "path", samples, "box"});
  for (const std::string mode : {"heat", "rays", "depth"})
    for (const int samples : {1, 3})
      for (const std::string filter : {"box", "gaussian"}) cases.push_back({"hello", mode, samples, filter});
  // This accelerator remembers most, so that what a pixel costs depends on those before it.
  cases.push_back({"hello", "heat", 2, "box", 37, 23, 1, "graph"});
  cases.push_back({"hello", "heat", 1, "lanczos", 37, 23, 1, "graph"});
  // Nothing moves in images of one sample, but lenses and motion take other kernels.
  cases.push_back({"lens", "whitted", 2, "box"});
  cases.push_back({"motion", "path", 2, "mitchell"});
  cases.push_back({"empty", "whitted", 2, "gaussian"});
  for (const int places : {1, 4, 16, 64})
    for (const int height : {1, 40}) cases.push_back({"hello", "whitted", 1, "box", 9, height, places});
  return cases;
}

// The image that was watched while it grew is the one that is saved; it must be the one that raypro makes.
TEST(RenderJob, GivesTheSameBitsAsRenderWhateverTheOrder) {
  for (const Case& c : Cases()) {
    AcceleratorSettings how;
    how.name = c.accelerator;
    const auto scene = Loaded(c.scene, how);
    const RenderResult whole = Render(scene->world, *scene->accelerator, c.Settings());
    for (const Order order : {Order::coarse_first, Order::rows}) {
      SCOPED_TRACE(c.Name() + (order == Order::rows ? " rows" : " coarse first"));
      const RenderJob job(scene, c.Settings(), order, c.first_places);
      ASSERT_TRUE(Ends(job));
      ASSERT_TRUE(job.IsComplete()) << job.Failure();
      const RenderResult& result = *job.Result();
      EXPECT_TRUE(result.image == whole.image);
      EXPECT_TRUE(Shows(job.frame(), result.image));
      EXPECT_EQ(job.Samples(), c.samples);
      EXPECT_EQ(result.pixels_done, whole.pixels_done);
      EXPECT_EQ(result.pixels_total, whole.pixels_total);
      EXPECT_EQ(result.samples.least, whole.samples.least);
      EXPECT_EQ(result.samples.most, whole.samples.most);
      EXPECT_EQ(result.samples.mean, whole.samples.mean);
      EXPECT_EQ(result.block_samples, whole.block_samples);
      EXPECT_EQ(result.planned_samples, whole.planned_samples);
      EXPECT_EQ(result.passes.size(), whole.passes.size());
      EXPECT_EQ(RaysByKind(result.rays), RaysByKind(whole.rays));
      if (order == Order::rows) {
        EXPECT_EQ(job.RowsDone(), c.height);
        continue;
      }
      EXPECT_EQ(job.Places(), 64);
      EXPECT_EQ(result.error.has_value(), whole.error.has_value());
      if (result.error && whole.error) {
        EXPECT_EQ(result.error->estimate, whole.error->estimate);
        EXPECT_EQ(result.error->worst_block, whole.error->worst_block);
      }
    }
  }
}

TEST(RenderJob, OfACropEqualsThatPartOfRenders) {
  const auto scene = Loaded("hello");
  for (const std::string filter : {"box", "gaussian"})
    for (const Order order : {Order::coarse_first, Order::rows}) {
      RenderSettings settings = Sized(50, 41);
      settings.filter = project::Named{filter};
      settings.samples = 3;
      settings.crop = {7, 5, 30, 40};
      const RenderJob job(scene, settings, order);
      ASSERT_TRUE(Ends(job));
      ASSERT_TRUE(job.IsComplete()) << job.Failure();
      EXPECT_TRUE(job.Result()->image == Render(scene->world, *scene->accelerator, settings).image) << filter;
      EXPECT_TRUE(Shows(job.frame(), job.Result()->image)) << filter;
    }
}

TEST(RenderJob, PassesAskedForAreToldOf) {
  const auto scene = Loaded("hello");
  RenderSettings settings = Sized(20, 20);
  settings.samples = 8;
  settings.wants_passes = true;
  const RenderJob job(scene, settings, Order::coarse_first);
  ASSERT_TRUE(Ends(job));
  ASSERT_TRUE(job.IsComplete());
  EXPECT_EQ(job.Result()->passes.size(), 4u);  // to 1, 2, 4 and 8 samples
}

// Passes apart are worth having only if they are the image's own rays.
TEST(RenderJob, TracesEachPixelOfOneSampleOnce) {
  const auto scene = Loaded("hello");
  for (const int width : {1, 37, 64})
    for (const int places : {1, 16, 64}) {
      const RenderJob job(scene, Sized(width, 23), Order::coarse_first, places);
      ASSERT_TRUE(Ends(job));
      ASSERT_TRUE(job.IsComplete());
      EXPECT_EQ(job.Result()->rays[RayKind::camera].rays, static_cast<std::uint64_t>(23 * width));
      EXPECT_EQ(job.Rays(), job.Result()->rays.Total());
    }
}

// Without it the live image would be full of holes: the pixels that lack a sample are filled as those of an image that
// is subsampled.
TEST(RenderJob, AWholeLookShowsTheImageOfItsPlaces) {
  RenderSettings settings = Sized(37, 23);
  settings.threads = 1;
  settings.mode = RenderMode::depth;
  const auto scene = Loaded("area_light");
  const Gated gated(0);
  RenderJob job(gated.scene, settings, Order::coarse_first, 1);
  std::int64_t opened = 0;
  for (const int places : {1, 4, 16}) {
    RenderSettings subsampled = settings;
    subsampled.places = places;
    const RenderResult whole = Render(scene->world, *scene->accelerator, subsampled);
    gated.gate->Open(whole.pixels_done - opened);
    opened = whole.pixels_done;
    while (job.Places() != places || gated.gate->Waiting() == 0) std::this_thread::yield();
    EXPECT_TRUE(Shows(job.frame(), whole.image)) << places;
  }
  job.Cancel();
  gated.gate->Open(1 << 20);
}

// What is drawn of an image under way is the image, not a guess at it; and what is not yet traced is black.
// With 20 lights, each point of the true image traces 20 shadow rays.
TEST(RenderJob, ShowsManyLightsByOneOfThemUntilTheTrueImageIsThere) {
  const project::Folder folder;
  std::string lights;
  for (int i = 0; i < 20; ++i) lights += "point_light 1 1 1  " + std::to_string(i - 10) + " 5 3  1 0 0\n";
  folder.Write("many.scn", lights + "material .1 .1 .1  .05 .05 .05  0 0 0  0 0 0  0 0 0  1 1 0\nsphere 0  0 0 0  2\n");
  RenderSettings settings = Sized(32, 32);
  settings.threads = 1;
  const Gated gated(0, folder / "many.scn");
  const RenderJob job(gated.scene, settings, Order::coarse_first, 1);
  const int quarter = 32 * 32 / 4;
  gated.gate->Open(quarter);
  while (job.Places() < 16 || gated.gate->Waiting() == 0) std::this_thread::yield();
  EXPECT_TRUE(job.IsOfOneLight());
  EXPECT_NE(StatusOf(job).find("one light per point"), std::string::npos);
  const std::uint64_t rays = job.Rays();
  EXPECT_LE(rays, 2u * quarter);
  const R2::Image by_one_light = job.frame().Image();
  gated.gate->Open(1 << 20);
  ASSERT_TRUE(Ends(job));
  EXPECT_FALSE(job.IsOfOneLight());
  const RenderResult whole = Render(gated.scene->world, *gated.scene->accelerator, settings);
  EXPECT_TRUE(job.Result()->image == whole.image);
  EXPECT_FALSE(by_one_light == whole.image);
  EXPECT_EQ(RaysByKind(job.Result()->rays), RaysByKind(whole.rays));
}

TEST(RenderJob, RowsBelowRowsDoneAreFinalAndThoseAboveUntouched) {
  const auto scene = Loaded("area_light");
  for (const std::string filter : {"box", "gaussian"}) {
    RenderSettings settings = Sized(48, 150);
    settings.threads = 1;  // several may be done with rows above first, which then come all at once
    settings.filter = project::Named{filter};
    settings.samples = 2;
    // In this mode nothing is black, so that black is proof.
    settings.mode = RenderMode::id;
    const R2::Image whole = Render(scene->world, *scene->accelerator, settings).image;
    const Gated gated(0);
    const RenderJob job(gated.scene, settings, Order::rows);
    // A row of blocks, and of a wide filter what the blocks above still add to.
    const int apron = Filter(settings.filter).Apron(), band = Film::block_side + apron;
    int looks = 0, last = -1;
    while (!job.HasEnded()) {
      if (gated.gate->IsShut()) gated.gate->Open(500);
      const int done_before = job.RowsDone();
      std::vector<float> shown;
      job.frame().Copy(0, settings.height, shown);
      const int done_after = job.RowsDone();
      const auto channels = [&](int rows) { return static_cast<std::ptrdiff_t>(3 * settings.width * rows); };
      ASSERT_TRUE(std::equal(shown.begin(), shown.begin() + channels(done_before), whole.Channels().begin()))
          << done_before;
      // The rows next to be done become so from one moment to the next, so they may have been seen half written.
      const int untouched = std::min(settings.height, done_after + band);
      ASSERT_EQ(std::count(shown.begin() + channels(untouched), shown.end(), 0.0f),
                channels(settings.height - untouched))
          << done_after;
      looks += done_before != last;
      last = done_before;
    }
    EXPECT_GE(looks, 4);
    EXPECT_TRUE(job.IsComplete());
  }
}

// A job that was stopped at a row shows that row and nothing of those above.
TEST(RenderJob, RowsNotReachedStayBlack) {
  for (const std::int64_t rays : {48 * 16, 48 * 16 + 20}) {
    RenderSettings settings = Sized(48, 40);
    settings.threads = 1;  // else some of the rays would be of the blocks above
    settings.mode = RenderMode::id;
    const Gated gated(rays);
    RenderJob job(gated.scene, settings, Order::rows);
    while (job.RowsDone() < 16 || gated.gate->Waiting() == 0) std::this_thread::yield();
    std::vector<float> rest;
    job.frame().Copy(16, 24, rest);
    EXPECT_EQ(rest, std::vector<float>(rest.size(), 0.0f));
    job.Cancel();
    gated.gate->Open(1 << 20);
    ASSERT_TRUE(Ends(job));
    rest.clear();
    job.frame().Copy(16, 24, rest);
    EXPECT_EQ(rest, std::vector<float>(rest.size(), 0.0f));
    EXPECT_EQ(job.RowsDone(), 16);
    EXPECT_FALSE(job.IsComplete());
    EXPECT_EQ(job.Result(), nullptr);
  }
}

// A render that was stopped is gone on with, in the viewer or by raypro: nothing of it may be lost, or come twice.
TEST(RenderJob, ContinuesWhatWasStoppedToTheSameBitsAndRays) {
  for (const std::string filter : {"box", "gaussian"})
    for (const bool is_denoised : {false, true})
      for (const std::int64_t rays : {40, 700, 2500}) {
        RenderSettings settings = Sized(48, 40);
        settings.filter = project::Named{filter};
        settings.samples = 4;
        settings.denoise = is_denoised;
        settings.mode = RenderMode::path;
        const Gated gated(rays);
        RenderJob first(gated.scene, settings, Order::rows);
        while (gated.gate->Waiting() == 0) std::this_thread::yield();
        first.Cancel();
        gated.gate->Open(1 << 30);
        ASSERT_TRUE(Ends(first));
        ASSERT_EQ(first.Result(), nullptr);
        if (!first.Canceled()) continue;
        const RenderJob second(gated.scene, settings, Order::rows, 1, first.Canceled());
        ASSERT_TRUE(Ends(second));
        ASSERT_TRUE(second.IsComplete()) << second.Failure();
        const RenderResult whole = Render(gated.scene->world, *gated.scene->accelerator, settings);
        EXPECT_TRUE(second.Result()->image == whole.image) << filter << " " << rays;
        EXPECT_EQ(RaysByKind(second.Result()->rays), RaysByKind(whole.rays));
      }
}

// Samples of a render that stops by its error come in two streams, and the claim is made from both.
TEST(RenderJob, WithAnErrorMatchesTheBitsAndClaimOfRender) {
  const auto scene = Loaded("area_light");
  for (const std::string filter : {"box", "gaussian"})
    for (const int ceiling : {1, 24})
      for (const Adaptive adaptive : {Adaptive::off, Adaptive::tile}) {
        RenderSettings settings = Sized(37, 23);
        settings.filter = project::Named{filter};
        settings.samples = ceiling;
        settings.budget.error = {2, ErrorUnit::display};
        settings.budget.adaptive = adaptive;
        const RenderResult whole = Render(scene->world, *scene->accelerator, settings);
        const RenderJob job(scene, settings, Order::coarse_first);
        ASSERT_TRUE(Ends(job));
        ASSERT_TRUE(job.IsComplete()) << job.Failure();
        const RenderResult& result = *job.Result();
        SCOPED_TRACE(filter + " " + std::to_string(ceiling));
        EXPECT_TRUE(result.image == whole.image);
        EXPECT_TRUE(Shows(job.frame(), whole.image));
        EXPECT_EQ(result.stop, whole.stop);
        EXPECT_EQ(result.block_samples, whole.block_samples);
        EXPECT_EQ(result.passes.size(), whole.passes.size());
        EXPECT_EQ(job.Samples(), std::lround(whole.samples.mean));
        ASSERT_TRUE(result.error && whole.error);
        EXPECT_EQ(result.error->estimate, whole.error->estimate);
        EXPECT_EQ(result.error->low, whole.error->low);
        EXPECT_EQ(result.error->high, whole.error->high);
      }
}

TEST(RenderJob, HasASampleOfEachPixelHoweverShortTheTime) {
  const auto scene = Loaded("area_light");
  for (const double seconds : {1e-9, 0.05}) {
    RenderSettings settings = Sized(40, 30);
    settings.budget.seconds = seconds;
    const RenderJob job(scene, settings, Order::coarse_first);
    ASSERT_TRUE(Ends(job));
    ASSERT_TRUE(job.IsComplete()) << job.Failure();
    EXPECT_EQ(job.Result()->stop, Stop::time);
    EXPECT_EQ(job.Result()->pixels_done, 40 * 30);
    EXPECT_GE(job.Samples(), 1);
    EXPECT_EQ(job.Share(), 1);
    EXPECT_EQ(job.SecondsLeft(), 0);
  }
}

// The first image once had samples that were not clamped, beside others that were.
TEST(RenderJob, ClampsTheFirstSampleLikeAllOthers) {
  const auto scene = Loaded("specular");
  for (const int samples : {1, 4}) {
    RenderSettings settings = Sized(48, 48);
    settings.samples = samples;
    settings.clamp = Clamp::samples;
    const R2::Image whole = Render(scene->world, *scene->accelerator, settings).image;
    settings.clamp = Clamp::image;
    ASSERT_FALSE(Render(scene->world, *scene->accelerator, settings).image == whole) << "nothing is that bright";
    settings.clamp = Clamp::samples;
    const RenderJob job(scene, settings, Order::coarse_first);
    ASSERT_TRUE(Ends(job));
    ASSERT_TRUE(job.IsComplete());
    EXPECT_TRUE(job.Result()->image == whole) << samples;
  }
}

TEST(RenderJob, CanceledCoarseFirstContinuesToTheSameImage) {
  RenderSettings settings = Sized(40, 30);
  settings.samples = 64;
  settings.threads = 1;
  const auto scene = Loaded("area_light");
  const RenderResult whole = Render(scene->world, *scene->accelerator, settings);
  RenderJob first(scene, settings, Order::coarse_first);
  while (first.Samples() < 2) std::this_thread::yield();
  first.Cancel();
  ASSERT_TRUE(Ends(first));
  ASSERT_TRUE(first.Canceled());
  EXPECT_EQ(first.Canceled()->image, first.frame().Image());
  RenderJob second(scene, settings, Order::coarse_first, 1, first.Canceled());
  EXPECT_GE(second.Samples(), 0);
  ASSERT_TRUE(Ends(second));
  ASSERT_TRUE(second.IsComplete());
  EXPECT_EQ(second.Result()->image, whole.image);
}

// An image is worth more when all of it is a little better than when a part of it is much better.
TEST(RenderJob, FinishesAndShowsEachPassBeforeTheNext) {
  const int pixels = 37 * 23;
  RenderSettings settings = Sized(37, 23);
  settings.threads = 1;
  settings.mode = RenderMode::depth;  // one ray a pixel
  settings.samples = 8;
  const auto scene = Loaded("area_light");
  const Gated gated(0);
  RenderJob job(gated.scene, settings, Order::coarse_first);
  RenderSettings replayed = settings;
  replayed.replay = Replay{};
  replayed.replay->planned_samples = 8;
  for (int samples = 1, before = 0; samples <= 4; before = samples, samples *= 2) {
    gated.gate->Open(std::int64_t{pixels} * (samples - before));
    // A batch of the next pass waits at the gate once all of this one went through.
    while (job.Samples() != samples || gated.gate->Waiting() == 0) std::this_thread::yield();
    replayed.replay->ends.push_back(static_cast<std::uint32_t>(samples));
    EXPECT_TRUE(Shows(job.frame(), Render(scene->world, *scene->accelerator, replayed).image)) << samples;
    EXPECT_EQ(job.Share(), samples / 8.0);
  }
  gated.gate->Open(1 << 20);
  ASSERT_TRUE(Ends(job));
  EXPECT_TRUE(job.IsComplete());
  EXPECT_EQ(job.Share(), 1);
}

// Costs took all their samples behind squares of two pixels.
TEST(RenderJob, CostsOfManySamplesAreShownPixelByPixelBeforehand) {
  RenderSettings settings = Sized(37, 23);
  settings.threads = 1;
  settings.mode = RenderMode::rays;
  settings.samples = 4;
  const Gated gated(0);
  RenderJob job(gated.scene, settings, Order::coarse_first);
  while (job.Samples() < 1 && !job.HasEnded())
    if (gated.gate->IsShut()) gated.gate->Open(1);
  EXPECT_FALSE(job.HasEnded()) << "further samples wait at the gate";
  job.Cancel();
  gated.gate->Open(1 << 20);
}

// The viewer cancels while the user drags; a wait would be felt.
TEST(RenderJob, CancelReturnsWhilePixelsAreStillBegun) {
  for (const Order order : {Order::coarse_first, Order::rows})
    for (const int threads : {1, 2, 4}) {
      const Gated gated(100);
      RenderSettings settings = Sized(64, 64);
      settings.threads = threads;
      settings.mode = RenderMode::depth;  // one ray a pixel
      RenderJob job(gated.scene, settings, order);
      while (gated.gate->Waiting() == 0) std::this_thread::yield();
      job.Cancel();  // would never return if it waited, for the gate is shut
      EXPECT_FALSE(job.HasEnded());
      gated.gate->Open(1 << 20);
      ASSERT_TRUE(Ends(job));
      EXPECT_FALSE(job.IsComplete());
      EXPECT_EQ(job.Failure(), "");
      // 100 went through, and each thread had begun a block.
      EXPECT_LE(job.Rays(), 100u + 64u * static_cast<unsigned>(threads)) << threads;
    }
}

/// Runs out of memory at some ray.
class Exhausted : public Accelerator {
 public:
  Exhausted(const World& world, std::int64_t rays) : Accelerator(world), left_(rays) {}

 private:
  void Nearest(const R3::Ray&, NearestHit&, Workspace&) const override {
    if (left_.fetch_sub(1) <= 0) throw std::bad_alloc();
  }
  bool Any(const R3::Ray&, Workspace&) const override { return false; }

  mutable std::atomic<std::int64_t> left_;
};

TEST(RenderJob, AThreadThatFailsEndsTheJobAndSaysWhy) {
  for (const Order order : {Order::coarse_first, Order::rows})
    for (const std::int64_t rays : {0, 100, 1024 + 700}) {
      const auto scene = Loaded("hello");
      scene->accelerator = std::make_unique<Exhausted>(scene->world, rays);
      RenderSettings settings = Sized(32, 32);
      settings.samples = 4;
      const RenderJob job(scene, settings, order);
      ASSERT_TRUE(Ends(job));
      EXPECT_FALSE(job.IsComplete());
      EXPECT_EQ(job.Result(), nullptr);
      EXPECT_EQ(job.Failure(), "out of memory");
    }
}

TEST(RenderJob, OutlivesWhoeverLoadedItsScene) {
  for (const Order order : {Order::coarse_first, Order::rows}) {
    auto scene = Loaded("texture");
    const R2::Image whole = Render(scene->world, *scene->accelerator, Sized(64, 64)).image;
    const std::weak_ptr<LoadedScene> seen = scene;
    {
      const RenderJob job(std::move(scene), Sized(64, 64), order);
      scene.reset();
      ASSERT_TRUE(Ends(job));
      ASSERT_TRUE(job.IsComplete());
      EXPECT_TRUE(job.Result()->image == whole);
      EXPECT_FALSE(seen.expired());
    }
    EXPECT_TRUE(seen.expired());
  }
}

Camera Moved(Camera camera, std::mt19937& random) {
  std::uniform_real_distribution<double> step(-0.3, 0.3);
  camera.eye = camera.eye + R3::Vector{step(random), step(random), step(random)};
  return camera;
}

// Jobs are started one after another while the last still runs, as when a user drags. A frame shared by two jobs showed
// pixels of the old view in the new image now and then. Images are small, so that a thousand take seconds.
TEST(RenderJob, RandomRestartsLeaveEveryFinishedImageRight) {
  std::mt19937 random(7);
  const std::vector<std::shared_ptr<LoadedScene>> scenes{Loaded("hello"), Loaded("area_light"), Loaded("texture")};
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  constexpr int times = 1000;
  JobQueue jobs;
  int finished = 0, wrong = 0;
  for (int i = 0; i < times; ++i) {
    const auto& scene = scenes[static_cast<std::size_t>(below(3))];
    RenderSettings settings = Sized(12 + below(21), 12 + below(21));
    settings.view = Moved(scene->parsed.scene.camera, random);
    settings.threads = 1 + below(3);
    settings.samples = 1 + below(3);
    const Order order = below(4) == 0 ? Order::rows : Order::coarse_first;
    const RenderJob& job = jobs.Start(scene, settings, order, 1 << 2 * below(4));
    if (below(3) == 0) {
      ASSERT_TRUE(Ends(job));
    } else {
      std::this_thread::sleep_for(std::chrono::microseconds(10 * below(100)));
    }
    if (job.IsComplete()) {
      ++finished;
      const R2::Image fresh = Render(scene->world, *scene->accelerator, settings).image;
      wrong += !(job.Result()->image == fresh) || !Shows(job.frame(), fresh);
    }
    ASSERT_EQ(job.Failure(), "");
  }
  EXPECT_EQ(wrong, 0) << "of " << finished;
  EXPECT_GE(finished, times / 4);
  jobs.Abandon();
  const auto start = Clock::now();
  while (jobs.Collect() > 0 && SecondsSince(start) < 60) std::this_thread::yield();
  EXPECT_EQ(jobs.Collect(), 0);
}

TEST(JobQueue, ANewJobDoesNotWaitForOldOnes) {
  JobQueue jobs;
  EXPECT_EQ(jobs.Current(), nullptr);
  std::vector<Gated> stuck;
  for (int i = 0; i < 3; ++i) {
    const Gated& one = stuck.emplace_back(0);
    jobs.Start(one.scene, Sized(32, 32), Order::coarse_first);
    while (one.gate->Waiting() == 0) std::this_thread::yield();
  }
  const RenderJob& job = jobs.Start(Loaded("hello"), Sized(32, 32), Order::coarse_first);
  ASSERT_TRUE(Ends(job));
  EXPECT_TRUE(job.IsComplete());
  EXPECT_EQ(jobs.Current(), &job);
  EXPECT_EQ(jobs.Collect(), 3);
  for (const Gated& one : stuck) one.gate->Open(1 << 20);
  const auto start = Clock::now();
  while (jobs.Collect() > 0 && SecondsSince(start) < 60) std::this_thread::yield();
  EXPECT_EQ(jobs.Collect(), 0);
  EXPECT_EQ(jobs.Current(), &job);
  jobs.Abandon();
  EXPECT_EQ(jobs.Current(), nullptr);
}

}  // namespace
}  // namespace ray
