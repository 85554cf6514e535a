#include "source/render/BlockRenderer.h"

namespace ray {

BlockRenderer::BlockRenderer(const Integrator& integrator, const CameraRays& camera, const Filter& filter,
                             const RenderSettings& settings, const Halt& halt)
    : tracer_(integrator, camera, settings), filter_(filter), halt_(halt) {}

bool BlockRenderer::Render(const PixelRectangle& pixels, int stream, std::uint32_t first, std::uint32_t last,
                           TraceState& state, BlockSums& sums) {
  tracer_.Clear();
  for (int row = pixels.y0; row < pixels.y1; ++row)
    for (int column = pixels.x0; column < pixels.x1; ++column) {
      const RandomKey pixel = tracer_.KeyOf(column, row, stream);
      for (std::uint32_t index = first; index < last; ++index) {
        tracer_.Add(column, row, pixel, index);
        if (!tracer_.IsFull()) continue;
        if (halt_.IsAsked()) return false;
        Trace(state, sums);
      }
    }
  if (halt_.IsAsked()) return false;
  Trace(state, sums);
  return true;
}

void BlockRenderer::Trace(TraceState& state, BlockSums& sums) {
  tracer_.Trace(state, [&](int column, int row, const CameraSample& sample, const R2::Color& radiance) {
    sums.Add(column, row, sample.x, sample.y, radiance, filter_);
  });
}

}  // namespace ray
