#pragma once

#include <optional>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// Clear and absorbing solids that contain one another, overlap or touch: which of them a path is inside of, and what
/// that makes of the surfaces that it meets. A path enters a solid where light goes through the solid's surface from
/// outside, and leaves it where light goes through from inside. MediumSets tells what fills a place inside several
/// solids.
///   - A surface with one material on both sides is not there for rays. So water that overlaps the wall of its glass by
///     a hair, or touches it, is bounded by glass, and not by a film of air or of water.
///   - Light is refracted between what fills the places on both sides of a surface.
///   - What a path is inside of absorbs light on the way to whatever the path meets, and on the way to lights.
/// Meshes that are not closed have no inside: the back of a triangle is the inner side, whatever else is there.
/// Scenes in which nothing is clear or absorbs need none of this.
class Media {
 public:
  Media(const World& world, const Accelerator& accelerator);

  /// Whether rays may go through something, or be inside of something that absorbs.
  bool AreNeeded() const { return are_needed_; }
  bool AreAbsorbing() const { return are_absorbing_; }

  /// What a camera ray starts inside of.
  MediumSets::Number At(const R3::Ray& ray, TraceState& state) const {
    auto& last = state.last_camera_ray;
    if (!last || !(last->origin == ray.origin && last->time == ray.time)) [[unlikely]]
      last = {ray.origin, ray.time, Find(ray, state)};
    return last->media;
  }
  /// Whether Arrive does nothing to a path: it was not inside of several solids or one that absorbs, and goes into the
  /// first or out of the last.
  bool IsPlain(const R3::Ray& ray, const PathState& path, const WorldHit& hit) const {
    return (path.media == 0 || !are_absorbing_) && IsFirstOrLast(ray, path, hit);
  }
  /// Takes a path that hits something on to the surface that it sees, past surfaces that are not there for it. The
  /// path's throughput loses what is absorbed on the way.
  void Arrive(R3::Ray& ray, PathState& path, std::optional<WorldHit>& hit, TraceState& state) const;
  /// Sets what a point's surface separates.
  void SetSides(ShadingPoint& p, TraceState& state) const;
  /// What is left of light after a distance inside of a set of solids.
  R2::Color LeftOf(const R2::Color& light, MediumSets::Number media, double distance, const TraceState& state) const;

 private:
  /// Whether the path goes into the first solid or out of the last, whose surface is always there.
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
  bool are_needed_ = false, are_absorbing_ = false;
  std::vector<std::uint32_t> media_;
};

}  // namespace ray
