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

/// Hits of camera rays go to state.hits.
void IntersectCameraRays(const Accelerator& accelerator, std::span<const CameraSample> samples, TraceState& state);

/// The rays of an integrator: traces them, together where they go nearly the same way, counts what they cost and tells
/// the recorder, if there is one.
class Tracer {
 public:
  Tracer(const World& world, const Accelerator& accelerator, bool shadows)
      : world_(world), accelerator_(accelerator), media_(world, accelerator), shadows_(shadows) {}

  /// Hits of camera rays go to state.hits.
  ///   returns   the points of those that hit something, in order
  std::vector<ShadingPoint> CameraHits(std::span<const CameraSample> samples, TraceState& state) const;

  std::optional<WorldHit> Intersect(R3::Ray& ray, PathState& path, TraceState& state) const {
    RecordRay(ray, path, state);
    auto hit = accelerator_.Intersect(ray, state.workspace);
    state.Count(path.kind, 1);
    Arrive(ray, path, hit, state);
    return hit;
  }
  /// Traces rays of one kind together, which RecordRay has been told of; where each hits goes to `hits`.
  void IntersectEach(RayKind kind, std::span<const R3::Ray> rays, std::optional<WorldHit>* hits,
                     TraceState& state) const {
    accelerator_.Intersect(rays, hits, state.workspace);
    state.Count(kind, rays.size());
  }
  /// A path that is found to hit something arrives at the surface that it sees.
  void Arrive(R3::Ray& ray, PathState& path, std::optional<WorldHit>& hit, TraceState& state) const {
    if (media_.AreNeeded() && hit && !media_.IsPlain(ray, path, *hit)) media_.Arrive(ray, path, hit, state);
  }
  /// A point whose path and hit are known becomes that of the surface it sees. Returns false where it sees none.
  bool Arrive(R3::Ray& ray, ShadingPoint& p, TraceState& state) const {
    if (!media_.AreNeeded() || media_.IsPlain(ray, p.path, p.hit)) return true;
    std::optional<WorldHit> seen = p.hit;
    media_.Arrive(ray, p.path, seen, state);
    if (seen) p.hit = *seen;
    return seen.has_value();
  }
  /// Makes the rest of points whose paths and hits are known.
  ///   ray_of   which ray of state.batch led to each point
  void Complete(std::span<const std::uint32_t> ray_of, std::span<ShadingPoint> points, TraceState& state) const;
  /// The surface where a path has arrived.
  ShadingPoint PointAt(const R3::Ray& ray, const PathState& path, const WorldHit& hit, TraceState& state) const {
    ShadingPoint p = ShadingPointAt(world_, ray, path, hit);
    SetSides(p, state);
    return p;
  }
  void SetSides(ShadingPoint& p, TraceState& state) const {
    if (media_.AreNeeded() && !IsBlack(p.material->kt)) media_.SetSides(p, state);
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

  /// A shadow ray of point number `index`: what reaches it, if nothing is in between, is added to state.arrived[index],
  /// at the latest by TraceShadowRays. None where the light is behind the surface itself, though the shading normal may
  /// face it.
  ///   throughput   of the path, as far as it is not in `reflected`
  ///   describe     names the light
  template <typename Describe>
  void AddShadowRay(const ShadingPoint& p, std::size_t index, const ShadowTarget& light, const R2::Color& reflected,
                    const R2::Color& throughput, const Describe& describe, TraceState& state) const {
    if (p.IsBehindSurface(light.to_light)) return;
    new (&state.shadows.Next()) R3::Ray(ShadowRay(p, light));  // made in place
    AddReflected(p, index, reflected, throughput, describe, state);
  }
  /// Adds shadow rays towards samples of one light, whose colors are what is reflected of them.
  ///   origin_of   gives the ShadowOrigin of the point that sees a sample, by the sample's number, and `index_of` the
  ///               number of that point
  ///   light       says all but the way
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
      // Number by number: whole vectors would be copied by way of the stack, and wait for it.
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
  /// Which shadow rays something stops; none where there are no shadows.
  void FindOccluded(std::span<const R3::Ray> shadow_rays, std::span<bool> are_occluded, TraceState& state) const;
  /// Takes a camera ray on to the surface that it sees; false where it sees none.
  bool StartInMedia(R3::Ray& ray, ShadingPoint& p, TraceState& state) const;
  /// `hit` is null where it hits nothing.
  void RecordCameraRay(const CameraSample& sample, ShadingPoint* hit, TraceState& state) const;
  /// What the next ray is for.
  template <typename Describe>
  void AddReflected(const ShadingPoint& p, std::size_t index, const R2::Color& reflected, const R2::Color& throughput,
                    const Describe& describe, TraceState& state) const {
    ShadowRays& shadows = state.shadows;
    const std::size_t i = shadows.count++;
    shadows.point[i] = index;
    R2::Color& left = shadows.reflected[i];
    left.r = reflected.r, left.g = reflected.g, left.b = reflected.b;
    if (p.path.media != 0 && media_.AreAbsorbing() && shadows.rays[i].t_max < R3::infinity)
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
