// Tests of rays against hulls of primitives in single precision, many at once, which find the certain misses. Included
// once per instruction set.

#if defined(RAY_ACCELERATE_WIDE_HULLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_HULLS_INL_H_
#undef RAY_ACCELERATE_WIDE_HULLS_INL_H_
#else
#define RAY_ACCELERATE_WIDE_HULLS_INL_H_
#endif

#include "source/accelerate/wide/HullBlock.h"
#include "source/accelerate/wide/Triangles-inl.h"

// A ray o + t d is M o + m + t M d in a hull's coordinates, where the hull's box is [-1, 1]^3. With u and r as in
// TraversalRay-inl.h, and N the largest sum of magnitudes of a row of M and m, which is at least 1 since no box is
// larger than the structure's:
//   - M and m are off by u of themselves and o by u r, and a product and three sums, fused or not, round by 4 u r N at
//     most: M o + m is off by 6 u r N. The components of d are 2 at most, so M d is off by 12 u N; and a ray is in the
//     box only at a t of at most r, since some component of d is at least 1: 12 u r N of the position there.
//   - The crossings with the planes of the box are off by 8 u r N in terms of the planes' positions, for a division, a
//     product and a sum; and the segment between them, P + s D with s from 0 to 1, by 4 u r N.
// So with planes moved outward by e = 32 u r N = 4 N plane errors, plus the loss of double precision on the way to the
// primitive, each point of it that the ray meets lies on P + s D, all coordinates within e. The profile's
//     Q = x^2 + z^2 + bulge y^2 - (radius + taper y)^2,
// at most 0 there, is off by 8 e + 8 e^2 for that, and by some 200 u < 7 e for rounding, since |P| <= 1 + e and |D| <=
// 2 + 2 e in each. Q is quadratic in s: a ray certainly misses if its minimum, which errors of its coefficients move by
// no more than themselves, is above 16 e (1 + e).
HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

using wide::HullBlock;

/// Hulls in SIMD lanes: one per lane, or a single hull broadcast to all lanes.
template <typename D>
struct HullLanes {
  using V = hn::Vec<D>;
  V turn[3][3], shift[3], radius, taper, bulge, stretch, margin;

  /// Loads the lanes; `get` makes a vector of the numbers of all hulls.
  template <typename Get>
  HWY_INLINE HullLanes(const HullBlock& block, const Get& get)
      : turn{{get(block.turn[0][0]), get(block.turn[0][1]), get(block.turn[0][2])},
             {get(block.turn[1][0]), get(block.turn[1][1]), get(block.turn[1][2])},
             {get(block.turn[2][0]), get(block.turn[2][1]), get(block.turn[2][2])}},
        shift{get(block.shift[0]), get(block.shift[1]), get(block.shift[2])},
        radius(get(block.radius)),
        taper(get(block.taper)),
        bulge(get(block.bulge)),
        stretch(get(block.stretch)),
        margin(get(block.margin)) {}
};

/// Rays in SIMD lanes, for hull tests.
template <typename D>
struct HullRays {
  using V = hn::Vec<D>;
  V origin[3], direction[3], plane_error, limit;
};

/// Returns the minimum of c + 2 b s + a s^2 for s from 0 to 1.
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE V LeastOfQuadratic(D d, V a, V b, V c) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1);
  const V turn = hn::Min(hn::Max(hn::Div(hn::Neg(b), a), zero), one);
  const V end = hn::IfThenElse(hn::Lt(hn::Add(a, hn::Add(b, b)), zero), one, zero);
  const V s = hn::IfThenElse(hn::Gt(a, zero), turn, end);
  return hn::MulAdd(s, hn::MulAdd(s, a, hn::Add(b, b)), c);
}

/// Returns the lanes in which the ray does not certainly miss the hull before its limit, and a lower bound on its
/// entry.
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE auto TestHullLanes(D d, const HullLanes<D>& hull, const HullRays<D>& ray, V& entry) {
  const auto set = [&](float x) { return hn::Set(d, x); };
  const V e = hn::MulAdd(hull.stretch, ray.plane_error, hull.margin), reach = hn::Add(set(1), e);
  V begin[3], along[3], exit = ray.limit;
  entry = hn::Zero(d);
  for (int i = 0; i < 3; ++i) {
    const V* const turn = hull.turn[i];
    begin[i] = hn::MulAdd(turn[0], ray.origin[0],
                          hn::MulAdd(turn[1], ray.origin[1], hn::MulAdd(turn[2], ray.origin[2], hull.shift[i])));
    along[i] = hn::MulAdd(turn[0], ray.direction[0],
                          hn::MulAdd(turn[1], ray.direction[1], hn::Mul(turn[2], ray.direction[2])));
    const V slope = hn::Div(set(1), hn::CopySign(hn::Max(hn::Abs(along[i]), set(flattest)), along[i]));
    const V middle = hn::Mul(begin[i], slope), half = hn::Mul(reach, hn::Abs(slope));
    entry = hn::Max(entry, hn::Neg(hn::Add(middle, half)));
    exit = hn::Min(exit, hn::Sub(half, middle));
  }
  const auto is_beside_box = hn::Gt(entry, exit);
  if (hn::AllTrue(d, is_beside_box)) return hn::Not(is_beside_box);

  const V way = hn::Sub(exit, entry);
  const auto from = [&](int i) { return hn::MulAdd(entry, along[i], begin[i]); };
  const V px = from(0), py = from(1), pz = from(2), pw = hn::MulAdd(hull.taper, py, hull.radius);
  const V dx = hn::Mul(way, along[0]), dy = hn::Mul(way, along[1]), dz = hn::Mul(way, along[2]);
  const V dw = hn::Mul(hull.taper, dy);
  const auto form = [&](V ax, V ay, V az, V aw, V bx, V by, V bz, V bw) {
    return hn::MulAdd(ax, bx, hn::MulAdd(az, bz, hn::MulSub(hn::Mul(hull.bulge, ay), by, hn::Mul(aw, bw))));
  };
  const V least = LeastOfQuadratic(d, form(dx, dy, dz, dw, dx, dy, dz, dw), form(px, py, pz, pw, dx, dy, dz, dw),
                                   form(px, py, pz, pw, px, py, pz, pw));
  const V slack = hn::Mul(hn::Mul(set(16), e), reach);
  return hn::Not(hn::Or(is_beside_box, hn::Gt(least, slack)));
}

/// Tests one ray, a TraversalRay or one of a packet, against the hulls of a block: returns those to be tested, as bits,
/// and where it enters them.
template <typename RayInBoxes>
HWY_INLINE std::uint32_t TestHulls(const HullBlock& block, const RayInBoxes& ray, float limit,
                                   float* HWY_RESTRICT entries) {
  const Lanes d;
  const auto set = [&](float x) { return hn::Set(d, x); };
  const HullRays<Lanes> rays{{set(ray.origin[0]), set(ray.origin[1]), set(ray.origin[2])},
                             {set(ray.direction[0]), set(ray.direction[1]), set(ray.direction[2])},
                             set(ray.plane_error),
                             set(limit)};
  std::uint32_t maybe = 0;
  for (std::size_t i = 0; i < width; i += hn::Lanes(d)) {
    const HullLanes<Lanes> hulls(block, [&](const float* numbers) { return hn::Load(d, numbers + i); });
    Floats entry;
    maybe |= Bits(d, TestHullLanes(d, hulls, rays, entry)) << i;
    hn::Store(entry, d, entries + i);
  }
  return maybe & ((std::uint32_t{1} << block.count) - 1);
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
