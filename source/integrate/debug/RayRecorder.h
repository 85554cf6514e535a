#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// A traced ray.
struct RecordedRay {
  static constexpr int none = -1;

  RayKind kind = RayKind::camera;
  int parent = none;       // the number of the ray at whose end this one started; none for camera rays
  int depth = 0;           // bounces before it
  R3::Ray ray;             // a shadow ray ends at its light at t = 1, unless that is infinitely far
  // of the light at its end, in its sample; for a shadow ray the arriving light if it is unoccluded
  R2::Color throughput;
  bool is_inside = false;                // it starts on the inside of the surface it comes from
  std::string towards{};                 // description of a shadow ray's light
  std::optional<WorldHit> hit{};         // its end; the nearest occluder of a shadow ray
  std::optional<R3::SurfacePoint> at{};  // the end in the world
  // The contribution to its sample, throughput included, without that of its children. All contributions sum to the
  // sample, unless that is on an outline, or shows a cost instead of light.
  R2::Color contribution{};
  // for a camera ray: the sample is black because it is on an outline
  bool is_outlined = false;

  /// Returns the point where it ends, if it does.
  std::optional<R3::Point> End() const {
    if (at) return at->position;
    if (kind == RayKind::shadow && ray.t_max < R3::infinity) return ray.At(1);
    return {};
  }
};

/// Records the rays of a few samples. A tracer whose TraceState has a recorder reports its rays to it. Only for a
/// recorder does the tracer find the nearest occluder of a shadow ray; everything else is traced anyway.
class RayRecorder {
 public:
  /// Records the beginning of a ray that comes from the end of ray `record`, if any. Returns its number.
  int Begin(const R3::Ray& ray, const PathState& path);
  /// Records its end on a surface, or nowhere; `contribution` as in RecordedRay.
  void Hits(const ShadingPoint& surface, const R2::Color& contribution);
  void Misses(int number, const R2::Color& contribution) { (*this)[number].contribution = contribution; }

  /// Records that a camera ray is on an outline.
  void OnOutline(int number) { (*this)[number].is_outlined = true; }

  /// Records a shadow ray of a surface. `reflected`: the arriving light if it is unoccluded, throughput included.
  void BeginShadow(const ShadingPoint& surface, const R3::Ray& ray, const R2::Color& reflected, std::string towards);
  /// Records the result of the shadow rays since the last call, for which `is_occluded(i)` (i from 0 in the order of
  /// BeginShadow) returns true if they are occluded. Finds their occluders now.
  template <typename IsOccluded>
  void EndShadows(const IsOccluded& is_occluded, const World& world, const Accelerator& accelerator,
                  Workspace& workspace) {
    for (std::size_t i = 0; i < shadows_.size(); ++i)
      EndShadow(shadows_[i], is_occluded(i), world, accelerator, workspace);
    shadows_.clear();
  }

  const std::vector<RecordedRay>& Rays() const { return rays_; }

 private:
  RecordedRay& operator[](int number) { return rays_[static_cast<std::size_t>(number)]; }
  int Keep(RecordedRay ray);
  void EndShadow(int number, bool is_occluded, const World& world, const Accelerator& accelerator,
                 Workspace& workspace);

  std::vector<RecordedRay> rays_;
  std::vector<int> shadows_;  // not ended yet
};

}  // namespace ray
