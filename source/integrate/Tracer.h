#pragma once

#include <span>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/integrate/Integrator.h"
#include "source/integrate/debug/RayRecorder.h"
#include "source/integrate/media/Media.h"
#include "source/integrate/shading/ShadingPoint.h"
#include "source/integrate/shading/ShadowStarts.h"
#include "source/scene/Light.h"

namespace ray {

/// Intersects camera rays. Stores their hits in state.hits.
void IntersectCameraRays(const Accelerator& accelerator, std::span<const CameraSample> samples, TraceState& state);

/// Traces the rays of an integrator, together if they are nearly parallel, counts their cost and reports them to the
/// recorder, if there is one.
class Tracer {
 public:
  Tracer(const World& world, const Accelerator& accelerator, bool shadows)
      : world_(world), accelerator_(accelerator), media_(world, accelerator), shadows_(shadows) {}

  /// Traces camera rays. Stores their hits in state.hits.
  ///   returns   the points of those that hit something, in order
  std::vector<ShadingPoint> CameraHits(std::span<const CameraSample> samples, TraceState& state) const;

  std::optional<WorldHit> Intersect(R3::Ray& ray, PathState& path, TraceState& state) const {
    RecordRay(ray, path, state);
    auto hit = accelerator_.Intersect(ray, state.workspace);
    state.Count(path.kind, 1);
    Arrive(ray, path, hit, state);
    return hit;
  }
  /// Traces rays of one kind together, which RecordRay has recorded. Writes one hit per ray to `hits`.
  void IntersectEach(RayKind kind, std::span<const R3::Ray> rays, std::optional<WorldHit>* hits,
                     TraceState& state) const {
    accelerator_.Intersect(rays, hits, state.workspace);
    state.Count(kind, rays.size());
  }
  /// Takes a path with a hit to the surface that it sees, past surfaces without an effect on it.
  void Arrive(R3::Ray& ray, PathState& path, std::optional<WorldHit>& hit, TraceState& state) const {
    if (media_.IsNeeded() && hit && !media_.IsPlain(ray, path, *hit)) media_.Arrive(ray, path, hit, state);
  }
  /// Moves a point whose path and hit are known to the surface that the path sees. Returns false if it sees none.
  bool Arrive(R3::Ray& ray, ShadingPoint& p, TraceState& state) const {
    if (!media_.IsNeeded() || media_.IsPlain(ray, p.path, p.hit)) return true;
    std::optional<WorldHit> seen = p.hit;
    media_.Arrive(ray, p.path, seen, state);
    if (seen) p.hit = *seen;
    return seen.has_value();
  }
  /// Completes points whose paths and hits are known.
  ///   ray_of   the ray of state.batch that led to each point
  void Complete(std::span<const std::uint32_t> ray_of, std::span<ShadingPoint> points, TraceState& state) const;
  /// Returns the surface where a path has arrived.
  ShadingPoint PointAt(const R3::Ray& ray, const PathState& path, const WorldHit& hit, TraceState& state) const {
    ShadingPoint p = ShadingPointAt(world_, ray, path, hit);
    SetSides(p, state);
    return p;
  }
  void SetSides(ShadingPoint& p, TraceState& state) const {
    if (media_.IsNeeded() && !IsBlack(p.material->kt)) media_.SetSides(p, state);
  }
  static void RecordRay(const R3::Ray& ray, PathState& path, TraceState& state) {
    if (state.recorder) [[unlikely]]
      path.record = state.recorder->Begin(ray, path);
  }
  static void RecordHit(const ShadingPoint& p, const R2::Color& contribution, TraceState& state) {
    if (state.recorder) [[unlikely]]
      state.recorder->Hits(p, contribution);
  }
  static void RecordMiss(int record, const R2::Color& contribution, TraceState& state) {
    if (state.recorder) [[unlikely]]
      state.recorder->Misses(record, contribution);
  }

  /// Adds a shadow ray of point number `index`. The light that reaches the point, if it is unoccluded, is added to
  /// state.arrived[index], by TraceShadowRays at the latest. Adds none if the light is behind the surface itself, even
  /// if the shading normal faces it.
  ///   throughput   of the path, as far as it is not included in `reflected`
  ///   describe     returns the name of the light
  template <typename Describe>
  void AddShadowRay(const ShadingPoint& p, std::size_t index, const ShadowTarget& light, const R2::Color& reflected,
                    const R2::Color& throughput, const Describe& describe, TraceState& state) const {
    if (p.IsBehindSurface(light.to_light)) return;
    new (&state.shadows.Next()) R3::Ray(ShadowRay(p, light));  // constructed in place
    AddReflected(p, index, reflected, throughput, describe, state);
  }
  /// Adds shadow rays towards samples of one light, whose colors are the reflected light.
  ///   origin_of   returns the ShadowOrigin of the point that sees a sample, by the sample's number
  ///   index_of    returns the number of that point
  ///   light       contains everything except the way
  template <typename OriginOf, typename IndexOf, typename Describe>
  void AddShadowRays(const OriginOf& origin_of, const IndexOf& index_of, const LightSamples& samples,
                     const ShadowStarts& starts, const ShadowTarget& light, const R2::Color& throughput,
                     const Describe& describe, TraceState& state) const {
    const double end = EndOf(light);
    for (std::uint32_t k = 0; k < samples.count; ++k) {
      const R2::Color reflected = samples.color[k];
      if (IsBlack(reflected)) continue;
      const ShadowOrigin& from = origin_of(k);
      const ShadingPoint& p = *from.point;
      const R3::Vector to_light = samples.to_light[k];
      if (p.IsBehindSurface(to_light)) continue;
      // Assigned one number at a time: whole vectors would be copied through the stack, with a stall.
      R3::Ray& ray = state.shadows.Next();
      ray.origin.x = from.place.x, ray.origin.y = from.place.y, ray.origin.z = from.place.z;
      ray.direction.x = to_light.x, ray.direction.y = to_light.y, ray.direction.z = to_light.z;
      ray.t_min = starts.begin[k], ray.t_max = end;
      ray.time = from.time;
      ray.leaving = LeavingTowards(from.leaving, starts.facing[k]), ray.leaving_until = R3::infinity;
      ray.reaching = light.reaching;
      ray.departure = &p.departure;
      AddReflected(p, index_of(k), reflected, throughput, describe, state);
    }
  }
  void TraceShadowRays(TraceState& state) const;

 private:
  /// Finds the shadow rays that are occluded; none if shadows are off.
  void FindOccluded(std::span<const R3::Ray> shadow_rays, std::span<bool> is_occluded, TraceState& state) const;
  /// Takes a camera ray to the surface that it sees. Returns false if it sees none.
  bool StartInMedia(R3::Ray& ray, ShadingPoint& p, TraceState& state) const;
  /// Records a camera ray. `hit` is null if it hits nothing.
  void RecordCameraRay(const CameraSample& sample, ShadingPoint* hit, TraceState& state) const;
  /// Records the light that the next shadow ray brings.
  template <typename Describe>
  void AddReflected(const ShadingPoint& p, std::size_t index, const R2::Color& reflected, const R2::Color& throughput,
                    const Describe& describe, TraceState& state) const {
    ShadowRays& shadows = state.shadows;
    const std::size_t i = shadows.count++;
    shadows.point[i] = index;
    R2::Color& left = shadows.reflected[i];
    left.r = reflected.r, left.g = reflected.g, left.b = reflected.b;
    if (p.path.media != 0 && media_.IsAbsorbing() && shadows.rays[i].t_max < R3::infinity)
      left = media_.LeftOf(left, p.path.media, Length(shadows.rays[i].direction), state);
    if (state.recorder) [[unlikely]]
      state.recorder->BeginShadow(p, shadows.rays[i], throughput * shadows.reflected[i], describe());
    if (shadows.IsFull()) TraceShadowRays(state);
  }

  const World& world_;
  const Accelerator& accelerator_;
  Media media_;
  bool shadows_;
};

}  // namespace ray
