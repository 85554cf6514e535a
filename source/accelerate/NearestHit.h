#pragma once

#include <algorithm>
#include <optional>

#include "source/accelerate/Workspace.h"
#include "source/accelerate/World.h"

namespace ray {

/// The nearest hit so far, by the rule that makes all accelerators agree: smallest t, among equals lowest primitive id.
/// It is kept where the answer is wanted.
class NearestHit {
 public:
  /// Of a ray that has hit nothing yet: `best` becomes empty.
  NearestHit(const World& world, const R3::Ray& ray, std::optional<WorldHit>& best)
      : world_(world), best_(best), limit_(ray.t_max) {
    best_.reset();
  }

  /// No hit at a larger t is wanted any more; one at exactly this t still is.
  double Limit() const { return limit_; }
  const std::optional<WorldHit>& Best() const { return best_; }
  /// The t_max of the ray, or less: a test that keeps below it misses no hit that is wanted.
  double TMaxOf(const R3::Ray& ray) const { return best_ ? std::min(ray.t_max, R3::NextUp(limit_)) : ray.t_max; }

  /// Tests one element, with the ray already in the instance's frame.
  void Test(std::uint32_t instance, int element, const R3::Ray& local, Counts& counts) {
    if (world_.Instances()[instance].IsEndOf(local, element)) return;
    ++counts.primitive_tests;
    const R3::Shape& shape = *world_.Instances()[instance].shape;
    const auto hit = best_ ? shape.Intersect(Shortened(local), element) : shape.Intersect(local, element);
    if (hit) Offer({*hit, instance, element});
  }

  /// Takes a hit that is no farther than Limit, unless it is as far and of a higher primitive.
  void Offer(const WorldHit& candidate) {
    if (best_ && candidate.t == best_->t && world_.PrimitiveId(candidate) >= world_.PrimitiveId(*best_)) return;
    // Number by number: a copy of the whole, in wider pieces than were stored, waits until the stores are in the cache.
    WorldHit& best = best_ ? *best_ : best_.emplace();
    best.t = candidate.t, best.u = candidate.u, best.v = candidate.v, best.part = candidate.part;
    best.instance = candidate.instance, best.element = candidate.element;
    limit_ = candidate.t;
  }

 private:
  R3::Ray Shortened(R3::Ray ray) const {
    ray.t_max = TMaxOf(ray);
    return ray;
  }

  const World& world_;
  std::optional<WorldHit>& best_;
  double limit_;
};

/// Sees a ray from one frame after the other, transforming it only when the frame changes.
class LocalRays {
 public:
  LocalRays(const World& world, const R3::Ray& ray) : world_(world), ray_(ray), local_(ray) {}

  const R3::Ray& In(std::uint32_t frame) {
    if (frame != frame_) {
      frame_ = frame;
      local_ = world_.Back(frame, ray_);
    }
    return local_;
  }

 private:
  const World& world_;
  const R3::Ray& ray_;
  std::uint32_t frame_ = 0;
  R3::Ray local_;
};

}  // namespace ray
