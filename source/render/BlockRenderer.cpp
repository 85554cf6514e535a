#include "source/render/BlockRenderer.h"

#include "source/integrate/Heat.h"

namespace ray {
namespace {

constexpr std::size_t most_together = 16;  // camera rays

// What the children of a pixel's key are for, besides those that CameraRays uses.
constexpr std::uint64_t second_stream = 2;

}  // namespace

BlockRenderer::BlockRenderer(const Integrator& integrator, const CameraRays& camera, const Filter& filter,
                             const RenderSettings& settings, const Halt& halt)
    : integrator_(integrator),
      camera_(camera),
      filter_(filter),
      seed_(settings.seed),
      is_heat_(settings.mode == "heat"),
      halt_(halt) {}

bool BlockRenderer::Render(const PixelRectangle& pixels, int stream, std::uint32_t first, std::uint32_t last,
                           TraceState& state, BlockSums& sums) {
  samples_.clear();
  places_.clear();
  // Where costs are the picture, each ray is alone, so that each pixel pays for its own.
  const std::size_t together = is_heat_ ? 1 : most_together;
  for (int row = pixels.y0; row < pixels.y1; ++row)
    for (int column = pixels.x0; column < pixels.x1; ++column) {
      const RandomKey own = seed_.Child(static_cast<std::uint64_t>(column)).Child(static_cast<std::uint64_t>(row));
      const RandomKey pixel = stream == 0 ? own : own.Child(second_stream);
      for (std::uint32_t index = first; index < last; ++index) {
        samples_.push_back(camera_(column, row, pixel, index));
        places_.push_back({column, row});
        if (samples_.size() < together) continue;
        if (halt_.IsAsked()) return false;
        Trace(state, sums);
      }
    }
  if (halt_.IsAsked()) return false;
  Trace(state, sums);
  return true;
}

void BlockRenderer::Trace(TraceState& state, BlockSums& sums) {
  radiances_.resize(samples_.size());
  const double heat_before = is_heat_ ? Heat(state.rays.Cost()) : 0;
  integrator_.Radiance(samples_, radiances_, state);
  if (is_heat_ && !samples_.empty()) {
    const double heat = Heat(state.rays.Cost()) - heat_before;
    radiances_[0] = {heat, heat, heat};
  }
  for (std::size_t i = 0; i < samples_.size(); ++i)
    sums.Add(places_[i].column, places_[i].row, samples_[i].x, samples_[i].y, radiances_[i], filter_);
  samples_.clear();
  places_.clear();
}

}  // namespace ray
