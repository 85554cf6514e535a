#pragma once

#include <algorithm>
#include <optional>

#include "R3/Point.h"
#include "R3/Ray.h"

namespace R3 {

/// An axis-aligned box, closed. The default box is empty, so that it can be extended from nothing.
struct Box {
  Point low{infinity, infinity, infinity};
  Point high{-infinity, -infinity, -infinity};

  bool IsEmpty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
  Vector Size() const { return high - low; }
  Point Center() const { return {low.x / 2 + high.x / 2, low.y / 2 + high.y / 2, low.z / 2 + high.z / 2}; }
  /// Half the diagonal; 0 when empty.
  double Radius() const { return IsEmpty() ? 0 : Length(Size()) / 2; }
  Point Corner(int i) const { return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}; }
  bool Contains(const Point& p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z && p.z <= high.z;
  }

  void Extend(const Point& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void Extend(const Box& b) {
    if (b.IsEmpty()) return;
    Extend(b.low);
    Extend(b.high);
  }

  friend bool operator==(const Box&, const Box&) = default;
};

/// Returns a box that contains `box` all the way along `way`.
inline Box Along(const Box& box, const Vector& way) {
  if (box.IsEmpty() || way == Vector{}) return box;
  Box all = box;
  all.Extend(Box{box.low + way, box.high + way});
  return all;
}

/// Returns the largest magnitude of a coordinate in the box; 0 if it is empty.
inline double Reach(const Box& box) {
  if (box.IsEmpty()) return 0;
  return std::max(MaxComponent(Abs(FromOrigin(box.low))), MaxComponent(Abs(FromOrigin(box.high))));
}

/// Returns the intersection of two boxes; empty if they do not overlap.
inline Box Common(const Box& a, const Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y), std::max(a.low.z, b.low.z)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y), std::min(a.high.z, b.high.z)}};
}

/// A ray prepared for many box tests.
struct BoxRay {
  explicit BoxRay(const Ray& ray)
      : origin(ray.origin),
        inverse{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z},
        t_min(ray.t_min),
        t_max(ray.t_max) {}

  Point origin;
  Vector inverse;  // 1 / direction; infinite, with its sign, for components +-0
  double t_min, t_max;
};

/// Returns the t at which the ray enters the box widened by `pad` on every side; std::nullopt if it certainly misses.
///   accuracy   never misses a box that the exact ray touches in [t_min, t_max]: the far side is padded by two ulp;
///              a ray lying in a face, an edge or a corner touches
///   pad        absolute, >= 0, in the box's units
///   source     Ize, Robust BVH ray traversal (2013), for the padding; Williams et al., An efficient and robust
///              ray-box intersection algorithm (2005), for the choice of sides by sign. A product 0 * infinity
///              is NaN when the ray lies in the plane of a face; the comparisons leave the interval as it was.
inline std::optional<double> Entry(const Box& box, const BoxRay& ray, double pad) {
  constexpr double far_padding = 1 + 2 * Gamma(3);
  double enter = ray.t_min, leave = ray.t_max;
  const auto clip = [&](double low, double high, double origin, double inverse) {
    const bool backwards = std::signbit(inverse);
    const double near_side = ((backwards ? high + pad : low - pad) - origin) * inverse;
    const double far_side = ((backwards ? low - pad : high + pad) - origin) * inverse * far_padding;
    enter = near_side > enter ? near_side : enter;
    leave = far_side < leave ? far_side : leave;
  };
  clip(box.low.x, box.high.x, ray.origin.x, ray.inverse.x);
  clip(box.low.y, box.high.y, ray.origin.y, ray.inverse.y);
  clip(box.low.z, box.high.z, ray.origin.z, ray.inverse.z);
  if (!(enter <= leave)) return {};
  return enter;
}

}  // namespace R3
