#include "source/integrate/Tracer.h"

#include <array>

#include "source/integrate/ShadingPoints.h"

namespace ray {

void IntersectCameraRays(const Accelerator& accelerator, std::span<const CameraSample> samples, TraceState& state) {
  state.batch.clear();
  for (const CameraSample& sample : samples) state.batch.push_back(sample.ray);
  state.hits.assign(samples.size(), {});
  accelerator.Intersect(state.batch, state.hits.data(), state.workspace);
  state.Count(RayKind::camera, samples.size());
}

std::vector<ShadingPoint> Tracer::CameraHits(std::span<const CameraSample> samples, TraceState& state) const {
  IntersectCameraRays(accelerator_, samples, state);
  std::vector<ShadingPoint> points;
  points.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    PathState path{.ray = samples[i].ray, .index = samples[i].index};
    if (state.recorder) path.record = state.recorder->Begin(path);
    if (state.hits[i]) {
      points.emplace_back(path, *state.hits[i]);
    } else if (state.recorder) {
      RecordMiss(path, Background(world_.scene(), path.ray.direction), state);
    }
  }
  if (state.recorder)  // which shows texture coordinates, whether the material has a use for them or not
    for (ShadingPoint& p : points) p = ShadingPointAt(world_, p.path, p.hit);
  else
    CompleteShadingPoints(world_, points);
  return points;
}

void Tracer::TraceShadowRays(TraceState& state) const {
  ShadowRays& shadows = state.shadows;
  std::array<bool, ShadowRays::capacity> are_occluded{};
  if (shadows_ && shadows.count > 0) {
    if (shadows.count == 1)
      are_occluded[0] = accelerator_.IsOccluded(shadows.rays[0], state.workspace);
    else
      accelerator_.IsOccluded(shadows.Rays(), are_occluded.data(), state.workspace);
    state.Count(RayKind::shadow, shadows.count);
  }
  if (state.recorder) [[unlikely]]
    state.recorder->EndShadows([&](std::size_t i) { return are_occluded[i]; }, world_, accelerator_, state.workspace);
  for (std::size_t i = 0; i < shadows.count; ++i)
    if (!are_occluded[i]) state.arrived[shadows.point[i]] += shadows.reflected[i];
  shadows.count = 0;
}

}  // namespace ray
