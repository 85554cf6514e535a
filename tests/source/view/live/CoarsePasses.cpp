#include "source/view/live/CoarsePasses.h"

#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "source/view/LoadedScene.h"
#include "tests/Project.h"

namespace ray {
namespace {

struct Bench {
  explicit Bench(int width, int height, int threads)
      : scene(project::Root() / "scenes" / "area_light.scn", {}, Graph()), frame(width, height) {
    settings.width = width;
    settings.height = height;
    settings.threads = threads;
    integrator = IntegratorOf(scene.world, *scene.accelerator, settings);
  }
  static AcceleratorSettings Graph() {
    AcceleratorSettings how;
    how.name = "graph";
    return how;
  }
  CoarsePasses::Watch Watch() { return {frame, stop, rays, begun_late}; }

  LoadedScene scene;
  RenderSettings settings;
  std::unique_ptr<const Integrator> integrator;
  Frame frame;
  std::atomic<bool> stop = false;
  std::atomic<std::uint64_t> rays = 0;
  std::atomic<std::int64_t> begun_late = 0;
};

// One thread tracing all pixels in one pass is the plainest way to the same samples.
TEST(CoarsePasses, TakeTheSameSamplesInAnyOrderOnAnyThreads) {
  Bench plain(37, 23, 1);
  const Film film = EmptyFilmOf(plain.settings);
  const CameraRays camera = CameraRaysOf(plain.scene.world, plain.settings);
  CoarsePasses all(*plain.integrator, camera, film, plain.settings, plain.Watch());
  ASSERT_TRUE(all.Trace(1, 0));
  const RenderState expected = all.TakeState();
  for (const int threads : {1, 3, 8})
    for (const int first : {64, 8, 2}) {
      Bench bench(37, 23, threads);
      CoarsePasses passes(*bench.integrator, camera, film, bench.settings, bench.Watch());
      for (int stride = first, traced = 0; stride >= 1; traced = stride, stride /= 2)
        ASSERT_TRUE(passes.Trace(stride, traced));
      EXPECT_EQ(passes.PixelsTraced(), 37 * 23);
      EXPECT_EQ(bench.begun_late, 0);
      for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 37; ++x) ASSERT_EQ(bench.frame.At(x, y), plain.frame.At(x, y)) << x << " " << y;
      const RenderState state = passes.TakeState();
      ASSERT_EQ(state.blocks.size(), expected.blocks.size());
      for (std::size_t i = 0; i < state.blocks.size(); ++i)
        EXPECT_TRUE(state.blocks[i].first_samples == expected.blocks[i].first_samples) << i;
    }
}

TEST(CoarsePasses, MayBeWatchedAndStoppedWhileTheyRun) {
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    Bench bench(48, 48, 3);
    const Film film = EmptyFilmOf(bench.settings);
    const CameraRays camera = CameraRaysOf(bench.scene.world, bench.settings);
    CoarsePasses passes(*bench.integrator, camera, film, bench.settings, bench.Watch());
    std::atomic<bool> is_over = false;
    std::thread viewer([&] {
      const auto enough = random() % 20'000;
      std::vector<float> shown;
      while (!is_over) {
        shown.clear();
        if (bench.frame.Version(20) > 0) bench.frame.Copy(16, 8, shown);
        if (bench.rays > enough) bench.stop = true;
      }
    });
    bool is_whole = true;
    for (int stride = 8, traced = 0; is_whole && stride >= 1; traced = stride, stride /= 2)
      is_whole = passes.Trace(stride, traced);
    is_over = true;
    viewer.join();
    EXPECT_EQ(bench.begun_late, 0);
    EXPECT_TRUE(is_whole || bench.stop);
    if (is_whole) {
      EXPECT_EQ(passes.PixelsTraced(), 48 * 48);
    }
  }
}

}  // namespace
}  // namespace ray
