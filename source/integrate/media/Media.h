#pragma once

#include <optional>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// Clear and absorbing solids that contain one another, overlap or touch: the solids that a path is inside of, and
/// their effect on surfaces. A path enters a solid when light passes through the solid's surface from outside, and
/// leaves it when light passes from inside. MediumSets defines the medium inside several solids.
///   - A surface with the same material on both sides has no effect on rays. So water that slightly overlaps the wall
///   of
///     its glass, or touches it, is bounded by glass, and not by a film of air or of water.
///   - Light is refracted between the media on both sides of a surface.
///   - Media absorb light on a path's way to its next surface, and on the way to lights.
/// Meshes that are not closed have no inside: the back of a triangle is the inner side, regardless of everything else.
/// Scenes without clear or absorbing materials need none of this.
class Media {
 public:
  Media(const World& world, const Accelerator& accelerator);

  /// Returns true if rays may pass through surfaces, or be inside of an absorbing solid.
  bool IsNeeded() const { return is_needed_; }
  bool IsAbsorbing() const { return is_absorbing_; }

  /// Returns the solids around the start of a camera ray.
  MediumSets::Number At(const R3::Ray& ray, TraceState& state) const {
    auto& last = state.last_camera_ray;
    if (!last || !(last->origin == ray.origin && last->time == ray.time)) [[unlikely]]
      last = {ray.origin, ray.time, Find(ray, state)};
    return last->media;
  }
  /// Returns true if Arrive does not change a path: it is not inside of several solids or an absorbing one, and enters
  /// the first or leaves the last.
  bool IsPlain(const R3::Ray& ray, const PathState& path, const WorldHit& hit) const {
    return (path.media == 0 || !is_absorbing_) && IsFirstOrLast(ray, path, hit);
  }
  /// Takes a path with a hit to the surface that it sees, past surfaces without an effect on it. Reduces the path's
  /// throughput by the absorption on the way.
  void Arrive(R3::Ray& ray, PathState& path, std::optional<WorldHit>& hit, TraceState& state) const;
  /// Sets the media on both sides of a point's surface.
  void SetSides(ShadingPoint& p, TraceState& state) const;
  /// Returns the remaining light after a distance inside of a set of solids.
  R2::Color LeftOf(const R2::Color& light, MediumSets::Number media, double distance, const TraceState& state) const;

 private:
  /// Returns true if the path enters the first solid or leaves the last, whose surface always has an effect.
  static bool IsFirstOrLast(const R3::Ray& ray, const PathState& path, const WorldHit& hit) {
    return MediumSets::IsWithin(path.media, hit.instance) && !IsNearStart(ray, hit.t);
  }
  MediumSets::Number Find(const R3::Ray& ray, TraceState& state) const;
  bool Passes(const R3::Ray& ray, const PathState& path, const WorldHit& hit, TraceState& state,
              MediumSets::Number& beyond) const;
  R3::Ray Beyond(const R3::Ray& ray, const PathState& path, const WorldHit& hit, TraceState& state) const;
  std::vector<std::uint32_t> Around(const R3::Point& p) const;

  const World& world_;
  const Accelerator& accelerator_;
  bool is_needed_ = false, is_absorbing_ = false;
  std::vector<std::uint32_t> media_;
};

}  // namespace ray
