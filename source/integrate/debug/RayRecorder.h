#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// A ray as it was traced.
struct RecordedRay {
  static constexpr int none = -1;

  RayKind kind = RayKind::camera;
  int parent = none;       // the ray whose end this one started from, by its number; a camera ray has none
  int depth = 0;           // bounces before it
  R3::Ray ray;             // a shadow ray ends at its light at t = 1, unless that is infinitely far
  R2::Color throughput;    // of what it sees, in its sample; of a shadow ray: what arrives if nothing is in between
  bool is_inside = false;  // whether it starts on the inside of the surface it comes from
  std::string towards{};   // the light of a shadow ray, in words
  std::optional<WorldHit> hit{};         // where it ends; the nearest thing in the way of a shadow ray
  std::optional<R3::SurfacePoint> at{};  // the same, in the world
  // To its sample, throughput included, besides what its children bring: all of them sum to the sample, unless that is
  // on an outline, or shows a cost in place of light.
  R2::Color contribution{};
  bool is_outlined = false;  // of a camera ray, whether its sample is black since it is on an outline

  /// Where it ends, if it does.
  std::optional<R3::Point> End() const {
    if (at) return at->position;
    if (kind == RayKind::shadow && ray.t_max < R3::infinity) return ray.At(1);
    return {};
  }
};

/// Keeps the rays of a few samples. A tracer whose TraceState names a recorder reports its rays to it. Only for a
/// recorder does the tracer find the nearest thing in the way of a shadow ray; all else is what it traces anyway.
class RayRecorder {
 public:
  /// A ray begins that comes from the end of ray `record`, if any; its own number.
  int Begin(const R3::Ray& ray, const PathState& path);
  /// It ends on a surface, or nowhere; `contribution` as above.
  void Hits(const ShadingPoint& surface, const R2::Color& contribution);
  void Misses(int number, const R2::Color& contribution) { (*this)[number].contribution = contribution; }

  /// A camera ray is on an outline.
  void OnOutline(int number) { (*this)[number].is_outlined = true; }

  /// A shadow ray of a surface. `reflected`: what arrives if nothing is in between, throughput included.
  void BeginShadow(const ShadingPoint& surface, const R3::Ray& ray, const R2::Color& reflected, std::string towards);
  /// The shadow rays begun since the last call were traced: those for which `is_occluded(i)`, i from 0 in the order
  /// they began, found something in their way. What that was is asked now.
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
  std::vector<int> shadows_;  // begun and not ended
};

}  // namespace ray
