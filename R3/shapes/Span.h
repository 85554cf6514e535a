#pragma once

#include <optional>

#include "R3/Box.h"
#include "R3/Crossings.h"
#include "R3/Hit.h"
#include "R3/Ray.h"

namespace R3 {

/// The stretch of a line inside a convex body, and the part of its surface that bounds each end.
struct Span {
  double enter = -infinity, leave = infinity;
  int enter_part = 0, leave_part = 0;

  /// Clips the span to [from, to]; a NaN bound stays and makes the span empty.
  void Clip(double from, double to, int from_part, int to_part) {
    if (from > enter || std::isnan(from)) enter = from, enter_part = from_part;
    if (to < leave || std::isnan(to)) leave = to, leave_part = to_part;
  }

  /// Returns the first end strictly inside the ray's interval. A body touched in one point counts as hit.
  std::optional<Hit> First(const Ray& ray) const { return First(ray.t_min, ray.t_max); }
  std::optional<Hit> First(double t_min, double t_max) const {
    if (!(enter <= leave)) return {};
    if (enter > t_min) return enter < t_max ? std::optional(Hit{enter, 0, 0, enter_part}) : std::nullopt;
    if (leave > t_min && leave < t_max) return Hit{leave, 0, 0, leave_part};
    return {};
  }
  /// Returns both ends, as repeated calls of First would.
  Crossings Ends(const Ray& ray) const {
    Crossings ends;
    const auto first = First(ray);
    if (!first) return ends;
    ends.Add(*first);
    if (const auto second = First(first->t, ray.t_max)) ends.Add(*second);
    return ends;
  }
};

/// Returns a t that no hit is below, for t_min below 0: clearly less than t_min.
inline double BeforeHits(double t_min) { return 2 * t_min; }

/// Returns true if a point is beyond a slab and heads away from it: such a line leaves no later t to ClipToSlab, and
/// this test needs no division.
inline bool IsLeavingSlab(double low, double high, double from, double direction) {
  return ((from >= high) & (direction > 0)) | ((from <= low) & (direction < 0));
}

/// Returns true if a ray starts beyond a box and heads away from it, as most rays do that start on a face.
inline bool IsLeavingBox(const Box& box, const Ray& ray) {
  const auto leaves_from = [&](const Point& p) {
    const auto leaves = [&](int axis) {
      return IsLeavingSlab(box.low[axis], box.high[axis], p[axis], ray.direction[axis]);
    };
    return leaves(0) + leaves(1) + leaves(2) > 0;  // a sum, so that there is only one branch
  };
  return leaves_from(ray.origin) && (ray.t_min >= 0 || leaves_from(ray.At(BeforeHits(ray.t_min))));
}

/// Clips to low <= coordinate <= high along one axis. Uses a division, not a reciprocal: one rounding fewer in t.
inline void ClipToSlab(Span& span, double low, double high, double origin, double direction, int low_part,
                       int high_part) {
  if (direction == 0) {  // the whole line is between the planes, or none of it
    if (!(low <= origin && origin <= high)) span.Clip(infinity, -infinity, low_part, high_part);
    return;
  }
  const double to_low = (low - origin) / direction, to_high = (high - origin) / direction;
  if (direction < 0)
    span.Clip(to_high, to_low, high_part, low_part);
  else
    span.Clip(to_low, to_high, low_part, high_part);
}

}  // namespace R3
