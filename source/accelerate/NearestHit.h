#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "source/accelerate/Contact.h"
#include "source/accelerate/Counts.h"
#include "source/accelerate/World.h"

namespace ray {

/// Returns true if the ray is finite with a nonzero direction; other rays hit nothing.
inline bool IsRay(const R3::Ray& ray) {
  const R3::Point& o = ray.origin;
  const R3::Vector& d = ray.direction;
  const double nought = 0 * o.x * o.y * o.z * d.x * d.y * d.z;  // NaN unless all are finite; avoids a branch for each
  return (nought == 0) & (ray.t_min < ray.t_max) & (MaxComponent(Abs(d)) > 0);
}

// Tests of a ray against an element of an instance: `ray` is in the world, `local` in the instance's frame and may end
// earlier.

/// Returns the first valid crossing from `begin` on.
std::optional<R3::Hit> FirstAhead(const World& world, const R3::Ray& ray, const R3::Ray& local, std::uint32_t instance,
                                  int element, double begin);

/// Returns the first valid crossing, starting at one near the ray's start.
std::optional<R3::Hit> FirstAheadFrom(const World& world, const R3::Ray& ray, const R3::Ray& local,
                                      std::uint32_t instance, int element, const R3::Hit& near_start);

/// Returns the first valid crossing; std::nullopt if the ray starts or ends on the element and cannot meet it.
inline std::optional<R3::Hit> FirstCrossing(const World& world, const R3::Ray& ray, const R3::Ray& local,
                                            std::uint32_t instance, int element, Counts& counts) {
  const Instance& met = world.Instances()[instance];
  const double begin = met.BeginOf(ray, element);
  if (begin == R3::infinity) return {};
  ++counts.primitive_tests;
  if (begin != ray.t_min) [[unlikely]]
    return FirstAhead(world, ray, local, instance, element, begin);
  auto hit = met.shape->Intersect(local, element);
  if (hit && IsNearStart(ray, hit->t)) [[unlikely]]
    hit = FirstAheadFrom(world, ray, local, instance, element, *hit);
  return hit;
}

/// Returns true if the element blocks a shadow ray that crosses it at `hit`, or from `begin` on.
bool IsInTheWayAt(const World& world, const R3::Ray& ray, const R3::Ray& local, std::uint32_t instance, int element,
                  const R3::Hit& hit);
bool IsInTheWayFrom(const World& world, const R3::Ray& ray, const R3::Ray& local, std::uint32_t instance, int element,
                    double begin);

/// Returns true if the element blocks a shadow ray.
inline bool IsInTheWay(const World& world, const R3::Ray& ray, const R3::Ray& local, std::uint32_t instance,
                       int element, Counts& counts) {
  const Instance& met = world.Instances()[instance];
  const double begin = met.BeginOf(ray, element);
  if (begin == R3::infinity) return false;
  ++counts.primitive_tests;
  if (begin != ray.t_min) [[unlikely]]
    return IsInTheWayFrom(world, ray, local, instance, element, begin);
  const auto hit = met.shape->Intersect(local, element);
  return hit && IsInTheWayAt(world, ray, local, instance, element, *hit);
}

/// The nearest hit so far, by a rule on which all accelerators agree: smallest t, among equals lowest primitive id. If
/// it may be coincident with others, Contact.h decides which of them is visible. Written directly to the caller's
/// result, with a mark if others may be coincident with it.
class NearestHit {
 public:
  /// Starts the search for a ray in the world; clears `best`.
  NearestHit(const World& world, const R3::Ray& ray, std::optional<WorldHit>& best)
      : world_(world), ray_(ray), best_(best), limit_(ray.t_max) {
    best_.reset();
  }
  /// Collects all hits up to the ray's t_max in `all`, instead of the nearest one.
  NearestHit(const World& world, const R3::Ray& ray, std::optional<WorldHit>& none, std::vector<WorldHit>& all)
      : NearestHit(world, ray, none) {
    all_ = &all;
  }

  /// Returns the limit beyond which hits are irrelevant.
  double Limit() const { return limit_; }
  const std::optional<WorldHit>& Best() const { return best_; }
  /// Returns the smaller of the ray's t_max and the limit: a test up to it misses no relevant hit.
  double TMaxOf(const R3::Ray& ray) const { return std::min(ray.t_max, limit_); }

  /// Tests one element, with the ray already in the instance's frame.
  void Test(std::uint32_t instance, int element, const R3::Ray& local, Counts& counts) {
    const auto hit = best_ ? FirstCrossing(world_, ray_, Shortened(local), instance, element, counts)
                           : FirstCrossing(world_, ray_, local, instance, element, counts);
    if (hit) Offer({*hit, instance, element});
  }
  /// Returns true if the element blocks a shadow ray.
  bool IsInTheWay(std::uint32_t instance, int element, const R3::Ray& local, Counts& counts) const {
    return ray::IsInTheWay(world_, ray_, local, instance, element, counts);
  }

  // Variants of Test and IsInTheWay for an element whose crossing is known, and which the ray crosses only once.
  void TakeIfAhead(const WorldHit& hit) {
    if (!IsNearStart(ray_, hit.t) || IsAhead(world_, ray_, hit)) [[likely]]
      Offer(hit);
  }
  bool IsInTheWay(const WorldHit& hit) const {
    return (!IsNearStart(ray_, hit.t) || IsAhead(world_, ray_, hit)) && ray::IsInTheWay(world_, ray_, hit);
  }

  /// Takes a hit at or before Limit, unless it is farther than the nearest, or equally far with a higher primitive.
  inline void Offer(const WorldHit& candidate) {
    if (all_) [[unlikely]]
      return all_->push_back(candidate);
    if (!best_) return Take(candidate, candidate.is_contested);
    const bool is_farther = candidate.t > best_->t;
    // Farther hits are offered only within the window.
    const bool is_contested = is_farther || best_->t <= EndOfCoincidence(world_, candidate.t);
    if (is_farther || (candidate.t == best_->t && world_.PrimitiveId(candidate) >= world_.PrimitiveId(*best_)))
      best_->is_contested = true;
    else
      Take(candidate, is_contested);
  }

 private:
  R3::Ray Shortened(R3::Ray ray) const {
    ray.t_max = TMaxOf(ray);
    return ray;
  }

  void Take(const WorldHit& candidate, bool is_contested) {
    // Copied by member: a copy of the whole, in wider pieces than were stored, would wait until the stores reach the
    // cache.
    WorldHit& best = best_ ? *best_ : best_.emplace();
    best.t = candidate.t, best.u = candidate.u, best.v = candidate.v, best.part = candidate.part;
    best.instance = candidate.instance, best.element = candidate.element;
    best.is_contested = is_contested;
    limit_ = EndOfCoincidence(world_, candidate.t);
  }

  const World& world_;
  const R3::Ray& ray_;
  std::optional<WorldHit>& best_;
  double limit_;
  std::vector<WorldHit>* all_ = nullptr;
};

/// The ray in the frames of successive instances, transformed only when the frame changes.
class LocalRays {
 public:
  LocalRays(const World& world, const R3::Ray& ray) : world_(world), ray_(ray) {}

  const R3::Ray& In(std::uint32_t frame) {
    if (frame == 0) return ray_;
    if (frame != frame_) {
      frame_ = frame;
      local_ = world_.Back(frame, ray_);
    }
    return *local_;
  }

 private:
  const World& world_;
  const R3::Ray& ray_;
  std::uint32_t frame_ = 0;
  std::optional<R3::Ray> local_;
};

}  // namespace ray
