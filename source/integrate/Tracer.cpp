#include "source/integrate/Tracer.h"

#include <array>

#include "source/integrate/shading/ShadingPoints.h"

namespace ray {

void IntersectCameraRays(const Accelerator& accelerator, std::span<const CameraSample> samples, TraceState& state) {
  state.batch.clear();
  for (const CameraSample& sample : samples) state.batch.push_back(sample.ray);
  state.hits.assign(samples.size(), {});
  accelerator.Intersect(state.batch, state.hits.data(), state.workspace);
  state.Count(RayKind::camera, samples.size());
}

std::vector<ShadingPoint> Tracer::CameraHits(std::span<const CameraSample> samples, TraceState& state) const {
  state.Begin();
  IntersectCameraRays(accelerator_, samples, state);
  std::vector<ShadingPoint> points;
  points.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (state.hits[i]) points.emplace_back(samples[i].ray, samples[i].index, *state.hits[i]);
    if (state.hits[i] && media_.AreNeeded() && !StartInMedia(points.back(), state)) {
      points.pop_back();
      state.hits[i].reset();
    }
    if (state.recorder) [[unlikely]]
      RecordCameraRay(samples[i], state.hits[i] ? &points.back() : nullptr, state);
  }
  Complete(points, state);
  return points;
}

void Tracer::Complete(std::span<ShadingPoint> points, TraceState& state) const {
  if (state.recorder)  // which shows texture coordinates, whether the material has a use for them or not
    for (ShadingPoint& p : points) p = ShadingPointAt(world_, p.path, p.hit);
  else
    CompleteShadingPoints(world_, points);
  if (media_.AreNeeded())
    for (ShadingPoint& p : points) SetSides(p, state);
}

bool Tracer::StartInMedia(ShadingPoint& p, TraceState& state) const {
  p.path.media = media_.At(p.path.ray, state);
  return Arrive(p, state);
}

void Tracer::RecordCameraRay(const CameraSample& sample, ShadingPoint* hit, TraceState& state) const {
  const int record = state.recorder->Begin({.ray = sample.ray, .index = sample.index});
  if (hit)
    hit->path.record = record;
  else
    state.recorder->Misses(record, Background(world_.scene(), sample.ray.direction));
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
