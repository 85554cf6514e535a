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

/// Pixels whose camera rays are traced together, and as many rays as are given at once. Where costs are the picture,
/// each ray is alone, so that each pixel pays for its own.
struct Batch {
  int side = 4;
  std::size_t rays = 16;
};
Batch BatchFor(const std::string& mode) { return mode == "heat" ? Batch{1, 1} : Batch{}; }

/// Renders the pixels of a block.
class BlockRenderer {
 public:
  BlockRenderer(const Whitted& tracer, const Camera& camera, const RenderSettings& settings)
      : tracer_(tracer), camera_(camera), settings_(settings), most_(BatchFor(settings.mode).rays) {}

  template <typename Store>
  void Render(const PixelRectangle& block, TraceState& state, const Store& store) {
    const double heat_before = settings_.mode == "heat" ? Heat(state.rays.Cost()) : 0;
    const auto count = static_cast<std::uint32_t>(settings_.samples);
    means_.assign(static_cast<std::size_t>(block.Area()), {});
    std::size_t place = 0;
    for (int y = block.y0; y < block.y1; ++y)
      for (int x = block.x0; x < block.x1; ++x, ++place) {
        const RandomKey pixel =
            RandomKey(settings_.seed).Child(static_cast<std::uint64_t>(x)).Child(static_cast<std::uint64_t>(y));
        const Stratified places(count, pixel.Child(0));
        for (std::uint32_t s = 0; s < count; ++s) {
          const R2::Point within = count == 1 ? R2::Point{0.5, 0.5} : places[s];
          samples_.push_back({camera_.Through(x + within.x, y + within.y, settings_.width, settings_.height),
                              pixel.Child(1).Child(s)});
          places_.push_back(place);
          if (samples_.size() == most_) Trace(state);
        }
      }
    Trace(state);
    place = 0;
    for (int y = block.y0; y < block.y1; ++y)
      for (int x = block.x0; x < block.x1; ++x, ++place)
        store(x, y,
              settings_.mode == "heat" ? HeatColor((Heat(state.rays.Cost()) - heat_before) / settings_.samples)
                                       : means_[place].Value());
  }

 private:
  void Trace(TraceState& state) {
    radiances_.resize(samples_.size());
    tracer_.Radiance(samples_, radiances_, state);
    for (std::size_t i = 0; i < samples_.size(); ++i) means_[places_[i]].Add(radiances_[i]);
    samples_.clear();
    places_.clear();
  }

  const Whitted& tracer_;
  const Camera& camera_;
  const RenderSettings& settings_;
  std::size_t most_;
  std::vector<PixelMean> means_;
  std::vector<Whitted::Sample> samples_;
  std::vector<std::size_t> places_;  // of each sample's pixel in the block
  std::vector<R2::Color> radiances_;
};

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
    BlockRenderer renderer(tracer, camera, settings);
    const Tiles blocks(tile, BatchFor(settings.mode).side);
    for (int i = 0; i < blocks.Count(); ++i) {
      if (monitor.stop && monitor.stop->load(std::memory_order_relaxed)) break;
      renderer.Render(blocks[i], state, [&](int x, int y, const R2::Color& color) {
        result.image.Set(x - whole.x0, y - whole.y0, color);
      });
      pixels += blocks[i].Area();
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
