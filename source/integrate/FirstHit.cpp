#include "source/integrate/FirstHit.h"

#include "source/integrate/ShadingPoint.h"
#include "source/integrate/debug/RayRecorder.h"

namespace ray {

void FirstHit::Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  state.batch.clear();
  for (const CameraSample& sample : samples) state.batch.push_back(sample.ray);
  state.hits.assign(samples.size(), {});
  accelerator_.Intersect(state.batch, state.hits.data(), state.workspace);
  state.Book(RayKind::camera, samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    radiances[i] = Seen(samples[i], state.hits[i]);
    if (state.recorder) Record(samples[i], state.hits[i], radiances[i], *state.recorder);
  }
}

void FirstHit::Record(const CameraSample& sample, const std::optional<WorldHit>& hit, const R2::Color& seen,
                      RayRecorder& recorder) const {
  PathState first{.ray = sample.ray, .index = sample.index};
  first.record = recorder.Begin(first);
  if (hit)
    recorder.Hits(ShadingPointAt(world_, first, *hit), seen);
  else
    recorder.Misses(first.record, seen);
}

R2::Color FirstHit::Seen(const CameraSample& sample, const std::optional<WorldHit>& hit) const {
  if (!hit) {
    if (layer_ == Layer::id) return {-1, -1, -1};
    return layer_ == Layer::albedo ? Background(world_.scene(), sample.ray.direction) : R2::Color{};
  }
  const ShadingPoint p = ShadingPointAt(world_, {.ray = sample.ray, .index = sample.index}, *hit);
  const double distance = hit->t * Length(sample.ray.direction);
  const auto id = static_cast<double>(world_.PrimitiveId(*hit));
  switch (layer_) {
    case Layer::depth:
      return {distance, distance, distance};
    case Layer::normal:
      return {p.N.x, p.N.y, p.N.z};
    case Layer::uv:
      return {p.at.uv.x, p.at.uv.y, 0};
    case Layer::albedo:
      return p.kd + p.material->kr + p.material->kt;
    case Layer::id:
      return {id, id, id};
  }
  return {};
}

namespace {

template <Layer layer>
std::unique_ptr<const Integrator> MakeFirstHit(const World& world, const Accelerator& accelerator,
                                               const TraceSettings&) {
  return std::make_unique<FirstHit>(world, accelerator, layer);
}

}  // namespace

extern const IntegratorKind depth_kind{"distance to the first surface", MakeFirstHit<Layer::depth>};
extern const IntegratorKind normal_kind{"its shading normal on the viewer's side", MakeFirstHit<Layer::normal>};
extern const IntegratorKind uv_kind{"its texture coordinates", MakeFirstHit<Layer::uv>};
extern const IntegratorKind albedo_kind{"what it scatters: kd, kr and kt", MakeFirstHit<Layer::albedo>};
extern const IntegratorKind id_kind{"the number of its primitive", MakeFirstHit<Layer::id>};

}  // namespace ray
