#include "source/render/RenderBlock.h"

namespace ray {

bool RenderBlock(const SampleSource& source, const SamplesDue& due, const Filter& filter, const std::atomic<bool>* stop,
                 TraceState& state, BlockSums& sums) {
  SampleBatch batch;
  const auto trace_and_splat = [&] {
    if (stop && stop->load(std::memory_order_relaxed)) return false;
    batch.Trace(
        source.integrator, state, [&](int column, int row, const CameraSample& sample, const R2::Color& radiance) {
          sums.Add(column, row, sample.x, sample.y, source.clamps_samples ? Clamped(radiance) : radiance, filter);
        });
    return true;
  };
  for (int row = due.pixels.y0; row < due.pixels.y1; ++row)
    for (int column = due.pixels.x0; column < due.pixels.x1; ++column) {
      const RandomKey key = source.PixelKey(column, row, due.stream);
      for (std::uint32_t index = due.first; index < due.last; ++index) {
        batch.Add(column, row, source.camera(column, row, key, index));
        if (batch.IsFull() && !trace_and_splat()) return false;
      }
    }
  return trace_and_splat();
}

}  // namespace ray
