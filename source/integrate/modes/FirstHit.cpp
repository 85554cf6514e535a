#include "source/integrate/modes/FirstHit.h"

#include "source/integrate/Tracer.h"

namespace ray {

void FirstHit::Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  IntersectCameraRays(accelerator_, samples, state);
  for (std::size_t i = 0; i < samples.size(); ++i) radiances[i] = SeenBy(samples[i], state.hits[i], state);
}

R2::Color FirstHit::SeenBy(const CameraSample& sample, const std::optional<WorldHit>& hit, TraceState& state) const {
  PathState path{.index = sample.index};
  if (state.recorder) path.record = state.recorder->Begin(sample.ray, path);
  if (!hit) {
    const R2::Color seen = Missed(sample.ray.direction);
    Tracer::RecordMiss(path.record, seen, state);
    return seen;
  }
  const ShadingPoint p = ShadingPointAt(world_, sample.ray, path, *hit);
  const R2::Color seen = Seen(p);
  Tracer::RecordHit(p, seen, state);
  return seen;
}

}  // namespace ray
