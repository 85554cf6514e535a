#include "source/integrate/FirstHit.h"

#include "source/integrate/debug/RayRecorder.h"

namespace ray {

void FirstHit::Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  state.batch.clear();
  for (const CameraSample& sample : samples) state.batch.push_back(sample.ray);
  state.hits.assign(samples.size(), {});
  accelerator_.Intersect(state.batch, state.hits.data(), state.workspace);
  state.Book(RayKind::camera, samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) radiances[i] = SeenBy(samples[i], state.hits[i], state);
}

R2::Color FirstHit::SeenBy(const CameraSample& sample, const std::optional<WorldHit>& hit, TraceState& state) const {
  PathState path{.ray = sample.ray, .index = sample.index};
  if (state.recorder) path.record = state.recorder->Begin(path);
  if (!hit) {
    const R2::Color seen = Missed(sample.ray.direction);
    if (state.recorder) state.recorder->Misses(path.record, seen);
    return seen;
  }
  const ShadingPoint p = ShadingPointAt(world_, path, *hit);
  const R2::Color seen = Seen(p);
  if (state.recorder) state.recorder->Hits(p, seen);
  return seen;
}

}  // namespace ray
