#include "source/render/Render.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>

#include "source/film/PixelMean.h"
#include "source/integrate/Heat.h"
#include "source/integrate/Whitted.h"

namespace ray {
namespace {

/// The rectangle cut into tiles, in rows from the bottom.
class Tiles {
 public:
  Tiles(const PixelRectangle& whole, int side) : whole_(whole) {
    side_ = side > 0 ? side : std::max(whole.x1 - whole.x0, whole.y1 - whole.y0);
    columns_ = (whole.x1 - whole.x0 + side_ - 1) / side_;
    rows_ = (whole.y1 - whole.y0 + side_ - 1) / side_;
  }

  int Count() const { return columns_ * rows_; }

  PixelRectangle operator[](int i) const {
    const int x0 = whole_.x0 + i % columns_ * side_, y0 = whole_.y0 + i / columns_ * side_;
    return {x0, y0, std::min(x0 + side_, whole_.x1), std::min(y0 + side_, whole_.y1)};
  }

 private:
  PixelRectangle whole_;
  int side_, columns_, rows_;
};

R2::Color RenderPixel(int x, int y, const Whitted& tracer, const Camera& camera, const RenderSettings& settings,
                      TraceState& state) {
  const double heat_before = settings.mode == "heat" ? Heat(state.rays.Cost()) : 0;
  const RandomKey pixel = RandomKey(settings.seed)
                              .Child(static_cast<std::uint64_t>(x))
                              .Child(static_cast<std::uint64_t>(y));
  PixelMean mean;
  for (int s = 0; s < settings.samples; ++s) {
    const R2::Point within = settings.samples == 1
                                 ? R2::Point{0.5, 0.5}
                                 : Stratified(static_cast<std::uint32_t>(s),
                                              static_cast<std::uint32_t>(settings.samples), pixel.Child(0));
    const R3::Ray ray = camera.Through(x + within.x, y + within.y, settings.width, settings.height);
    mean.Add(tracer.Radiance(ray, pixel.Child(1).Child(static_cast<std::uint64_t>(s)), state));
  }
  if (settings.mode == "heat") return HeatColor((Heat(state.rays.Cost()) - heat_before) / settings.samples);
  return mean.Value();
}

}  // namespace

double ExpectedRays(const RenderSettings& settings) {
  constexpr double rays_of_a_camera_ray = 3;  // with shadows and reflections, in scenes of the course
  const double pixels = settings.crop ? static_cast<double>(settings.crop->Area())
                                      : static_cast<double>(settings.width) * settings.height;
  return rays_of_a_camera_ray * pixels * settings.samples;
}

RenderResult Render(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                    const RenderMonitor& monitor) {
  const PixelRectangle whole = settings.crop.value_or(PixelRectangle{0, 0, settings.width, settings.height});
  const Tiles tiles(whole, settings.tile_size);
  const Whitted tracer(world, accelerator.Worker(), settings.trace);
  const Camera& camera = world.TheScene().camera;

  RenderResult result;
  result.image = R2::Image(whole.x1 - whole.x0, whole.y1 - whole.y0);
  result.pixels_total = whole.Area();
  std::mutex sums;  // guards the counts of `result` and the monitor; pixels belong to one tile each and need no guard

  const auto render_tile = [&](const PixelRectangle& tile, TraceState& state) {
    state.workspace.ForgetPlaces();
    state.rays = {};
    std::int64_t pixels = 0;
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        if (monitor.stop && monitor.stop->load(std::memory_order_relaxed)) break;
        result.image.Set(x - whole.x0, y - whole.y0, RenderPixel(x, y, tracer, camera, settings, state));
        ++pixels;
      }
    const std::lock_guard lock(sums);
    result.pixels_done += pixels;
    result.rays += state.rays;
    if (monitor.tile_done) monitor.tile_done({result.pixels_done, result.pixels_total, result.rays.Total()});
  };

  const int threads = settings.threads > 0 ? settings.threads : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  tbb::enumerable_thread_specific<TraceState> states;
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, tiles.Count()),
        [&](const tbb::blocked_range<int>& range) {
          for (int i = range.begin(); i != range.end(); ++i) render_tile(tiles[i], states.local());
        },
        tbb::simple_partitioner());
  });
  return result;
}

}  // namespace ray
