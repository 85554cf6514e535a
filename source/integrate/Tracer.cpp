#include "source/integrate/Tracer.h"

#include <algorithm>
#include <array>

#include "source/integrate/shading/ShadingPoints.h"

namespace ray {

void IntersectCameraRays(const Accelerator& accelerator, std::span<const CameraSample> samples, TraceState& state) {
  state.batch.clear();
  for (const CameraSample& sample : samples) state.batch.push_back(sample.ray);
  state.hits.resize(std::max(state.hits.size(), samples.size()));
  accelerator.Intersect(state.batch, state.hits.data(), state.workspace);
  state.Count(RayKind::camera, samples.size());
}

std::vector<ShadingPoint> Tracer::CameraHits(std::span<const CameraSample> samples, TraceState& state) const {
  state.Begin();
  IntersectCameraRays(accelerator_, samples, state);
  std::vector<ShadingPoint> points;
  points.reserve(samples.size());
  state.ray_of.clear();
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    std::optional<WorldHit>& hit = state.hits[i];
    if (hit) {
      ShadingPoint& p = points.emplace_back(samples[i].ray, samples[i].index, *hit);
      if (media_.IsNeeded() && !StartInMedia(state.batch[i], p, state))
        points.pop_back(), hit.reset();
      else
        state.ray_of.push_back(i);
    }
    if (state.recorder) [[unlikely]]
      RecordCameraRay(samples[i], hit ? &points.back() : nullptr, state);
  }
  Complete(state.ray_of, points, state);
  return points;
}

void Tracer::Complete(std::span<const std::uint32_t> ray_of, std::span<ShadingPoint> points, TraceState& state) const {
  // recorders show positions, and texture coordinates even if the material does not use them
  if (state.recorder)
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = ShadingPointAt(world_, state.batch[ray_of[i]], points[i].path, points[i].hit);
  else
    CompleteShadingPoints(world_, state.batch, ray_of, points);
  if (media_.IsNeeded())
    for (ShadingPoint& p : points) SetSides(p, state);
}

bool Tracer::StartInMedia(R3::Ray& ray, ShadingPoint& p, TraceState& state) const {
  p.path.media = media_.At(ray, state);
  return Arrive(ray, p, state);
}

void Tracer::RecordCameraRay(const CameraSample& sample, ShadingPoint* hit, TraceState& state) const {
  const int record = state.recorder->Begin(sample.ray, {.index = sample.index});
  if (hit)
    hit->path.record = record;
  else
    state.recorder->Misses(record, Background(world_.scene(), sample.ray.direction));
}

void Tracer::FindOccluded(std::span<const R3::Ray> shadow_rays, std::span<bool> is_occluded, TraceState& state) const {
  if (!shadows_) {
    std::ranges::fill(is_occluded, false);
    return;
  }
  if (shadow_rays.size() == 1)
    is_occluded[0] = accelerator_.IsOccluded(shadow_rays[0], state.workspace);
  else
    accelerator_.IsOccluded(shadow_rays, is_occluded.data(), state.workspace);
  state.Count(RayKind::shadow, shadow_rays.size());
}

void Tracer::TraceShadowRays(TraceState& state) const {
  ShadowRays& shadows = state.shadows;
  if (shadows.count == 0) return;
  std::array<bool, ShadowRays::capacity> is_occluded;
  FindOccluded(shadows.Rays(), is_occluded, state);
  if (state.recorder) [[unlikely]]
    state.recorder->EndShadows([&](std::size_t i) { return is_occluded[i]; }, world_, accelerator_, state.workspace);
  for (std::size_t i = 0; i < shadows.count; ++i)
    if (!is_occluded[i]) state.arrived[shadows.point[i]] += shadows.reflected[i];
  shadows.count = 0;
}

}  // namespace ray
