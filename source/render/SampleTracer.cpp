#include "source/render/SampleTracer.h"

#include "source/integrate/debug/Heat.h"

namespace ray {
namespace {

constexpr std::size_t packet_size = 16;  // camera rays

}  // namespace

// Where costs are the picture, each ray is alone, so that each pixel pays for its own.
SampleTracer::SampleTracer(const Integrator& integrator, const CameraRays& camera, const RenderSettings& settings)
    : integrator_(integrator),
      camera_(camera),
      seed_(settings.seed),
      shows_costs_(ShowsCosts(settings.mode)),
      counts_rays_(settings.mode == RenderMode::rays),
      together_(shows_costs_ ? 1 : packet_size) {}

double SampleTracer::CostSoFar(const TraceState& state) const {
  return counts_rays_ ? static_cast<double>(state.rays.Total()) : Heat(state.rays.Cost());
}

void SampleTracer::FindRadiances(TraceState& state) {
  radiances_.resize(samples_.size());
  const double before = shows_costs_ ? CostSoFar(state) : 0;
  integrator_.Li(samples_, radiances_, state);
  if (!shows_costs_ || samples_.empty()) return;
  const double cost = CostSoFar(state) - before;
  radiances_[0] = {cost, cost, cost};
}

}  // namespace ray
