#include "source/render/SampleTracer.h"

#include "source/integrate/Heat.h"

namespace ray {
namespace {

constexpr std::size_t most_together = 16;  // camera rays

}  // namespace

// Where costs are the picture, each ray is alone, so that each pixel pays for its own.
SampleTracer::SampleTracer(const Integrator& integrator, const CameraRays& camera, const RenderSettings& settings)
    : integrator_(integrator),
      camera_(camera),
      seed_(settings.seed),
      is_heat_(settings.mode == "heat"),
      together_(is_heat_ ? 1 : most_together) {}

void SampleTracer::FindRadiances(TraceState& state) {
  radiances_.resize(samples_.size());
  const double heat_before = is_heat_ ? Heat(state.rays.Cost()) : 0;
  integrator_.Radiance(samples_, radiances_, state);
  if (!is_heat_ || samples_.empty()) return;
  const double heat = Heat(state.rays.Cost()) - heat_before;
  radiances_[0] = {heat, heat, heat};
}

}  // namespace ray
