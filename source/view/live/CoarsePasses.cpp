#include "source/view/live/CoarsePasses.h"

#include <algorithm>
#include <utility>

#include "source/integrate/debug/Heat.h"
#include "source/render/Threads.h"

namespace ray {
namespace {

// The size of a work item, in pixels of its pass. Wide enough for full batches; the first pass has so few pixels that
// its items are low, to give all threads some.
constexpr int item_width = 8, item_height = 8, first_item_height = 2;

int Quotient(int pixels, int side) { return (pixels + side - 1) / side; }  // rounded up

}  // namespace

CoarsePasses::CoarsePasses(const Integrator& integrator, const CameraRays& camera, const Film& film,
                           const RenderSettings& settings, const Watch& watch)
    : source_{integrator, camera, RandomKey(settings.seed), settings.clamp == Clamp::samples},
      film_(film),
      watch_(watch),
      is_heat_(ShowsCosts(settings.mode)),
      sampled_(film.Sampled()),
      threads_(settings.threads),
      colors_(static_cast<std::size_t>(sampled_.Area())) {}

bool CoarsePasses::Trace(int stride, int traced_stride) {
  const int width = item_width * stride, height = (traced_stride > 0 ? item_height : first_item_height) * stride;
  const int columns = Quotient(sampled_.Width(), width), rows = Quotient(sampled_.Height(), height);
  std::atomic<int> begun = 0;  // in their order, so that the picture fills from the bottom
  std::atomic<bool> goes_on = true;
  ForEachOnThreads(threads_, columns * rows, [&](int) {
    if (!goes_on) return;
    const int i = begun++, x = sampled_.x0 + i % columns * width, y = sampled_.y0 + i / columns * height;
    if (!TraceItem({Common(sampled_, {x, y, x + width, y + height}), stride, traced_stride}, workers_.local()))
      goes_on = false;
  });
  return goes_on;
}

bool CoarsePasses::TraceItem(const Item& item, Worker& worker) {
  const PixelRectangle& pixels = item.pixels;
  const auto is_traced = [&](int column, int row) {
    return item.traced_stride > 0 && (column - sampled_.x0) % item.traced_stride == 0 &&
           (row - sampled_.y0) % item.traced_stride == 0;
  };
  worker.state.stop = &watch_.stop;
  worker.state.workspace.ForgetLastHits();
  BatchTracer tracer(source_, worker.state, [&](int column, int row, const CameraSample&, const R2::Color& radiance) {
    colors_[Index(column, row)] = radiance;
    Show(column, row, item.stride, radiance);
    ++worker.pixels_traced;
  });
  bool was_stopped = watch_.stop.load();
  const auto reported = [&](bool goes_on) {
    if (!tracer.IsEmpty()) return goes_on;
    Report(was_stopped, worker);
    was_stopped = watch_.stop.load();
    return goes_on;
  };
  for (int row = pixels.y0; row < pixels.y1; row += item.stride)
    for (int column = pixels.x0; column < pixels.x1; column += item.stride)
      if (!is_traced(column, row) && !reported(tracer.Add(source_.FirstSample(column, row)))) return false;
  if (!reported(tracer.Finish())) return false;
  const int bottom = film_.Region().y0;
  for (int row = std::max(pixels.y0, bottom); row < std::min(pixels.y1, film_.Region().y1); ++row)
    watch_.frame.Touch(row - bottom);
  return true;
}

/// What the worker has traced since its last report. `was_stopped_before`: whether stop was asked for before the batch
/// was laid together; asked of the look before the tracer's, so that the count tells if that one were missing.
void CoarsePasses::Report(bool was_stopped_before, Worker& worker) {
  const std::int64_t pixels = worker.pixels_traced - std::exchange(worker.pixels_reported, worker.pixels_traced);
  if (was_stopped_before) watch_.begun_late += pixels;
  pixels_traced_ += pixels;
  const std::uint64_t rays = worker.state.rays.Total();
  watch_.rays += rays - std::exchange(worker.rays_reported, rays);
}

void CoarsePasses::Show(int column, int row, int stride, const R2::Color& radiance) {
  const PixelRectangle& region = film_.Region();
  const R2::Color color = is_heat_ ? HeatColor(radiance.r) : radiance;
  const PixelRectangle square = Common(region, {column, row, column + stride, row + stride});
  for (int y = square.y0; y < square.y1; ++y)
    for (int x = square.x0; x < square.x1; ++x) watch_.frame.Set(x - region.x0, y - region.y0, color);
}

RenderState CoarsePasses::TakeState() {
  const auto blocks = static_cast<std::size_t>(film_.Blocks());
  RenderState state;
  state.blocks.resize(blocks);
  state.schedule.targets = {std::vector<std::uint32_t>(blocks, 0),
                            std::vector<std::uint8_t>(blocks, BlockOrder::places)};
  for (int i = 0; i < film_.Blocks(); ++i) {
    std::vector<R2::Color>& looks = state.blocks[static_cast<std::size_t>(i)].first_samples;
    looks.resize(BlockOrder::places);
    const PixelRectangle pixels = film_.PixelsOf(i);
    for (int row = pixels.y0; row < pixels.y1; ++row)
      for (int column = pixels.x0; column < pixels.x1; ++column)
        looks[static_cast<std::size_t>(BlockOrder::PlaceOf(column, row))] = colors_[Index(column, row)];
  }
  colors_ = {};
  for (const Worker& worker : workers_) state.rays += worker.state.rays;
  return state;
}

}  // namespace ray
