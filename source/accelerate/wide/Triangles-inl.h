// Tests of rays against triangles in single precision, many at once, which find certain misses and certain hits. The
// bounds are derived in TraversalRay-inl.h. Included once per instruction set.

#if defined(RAY_ACCELERATE_WIDE_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_TRIANGLES_INL_H_
#undef RAY_ACCELERATE_WIDE_TRIANGLES_INL_H_
#else
#define RAY_ACCELERATE_WIDE_TRIANGLES_INL_H_
#endif

#include "source/accelerate/wide/TraversalRay-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

/// Triangles in SIMD lanes: one per lane, or a single triangle broadcast to all lanes.
template <typename D>
struct TriangleLanes {
  using V = hn::Vec<D>;
  Vec3<D> edge1, edge2, normal;
  V edges, area;  // sum and product of the edges' magnitudes
};

/// Loads the triangles of a block.
template <typename D>
HWY_INLINE TriangleLanes<D> LoadTriangles(D d, const TriangleBlock& block, std::size_t first) {
  const Vec3<D> edge1 = LoadEach(d, block.edge1, first), edge2 = LoadEach(d, block.edge2, first);
  const auto a = SumOfAbs(edge1), b = SumOfAbs(edge2);
  return {edge1, edge2, Cross(edge1, edge2), hn::Add(a, b), hn::Mul(a, b)};
}

/// Rays in SIMD lanes: one per lane, or a single ray broadcast to all lanes.
template <typename D>
struct RayLanes {
  Vec3<D> direction;
  hn::Vec<D> certain_from, edge_error, height_error, limit;
};

/// The lanes that may hit, and bounds on their distances.
template <typename D>
struct TriangleMask {
  HWY_INLINE TriangleMask() {}  // a compiler-generated one would not be compiled for the instruction set

  hn::Mask<D> maybe, certain;  // `certain` is a subset of `maybe`
  hn::Vec<D> nearest;          // lower bounds on the distances; 0 for those that are unclear
  hn::Vec<D> farthest;         // upper bounds, of the certain ones
};

/// Finds the triangles that their ray does not certainly miss before its limit; returns false if there are none, with
/// the rest unspecified.
///   to_corner   from the ray's origin to the triangle's first corner
///   v, w, rest  the hit's barycentric coordinates times n . d
///   source      the edge functions of Moller, Trumbore, Fast, minimum storage ray/triangle intersection (1997),
///               undivided
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE bool TestLanes(D d, const TriangleLanes<D>& triangle, const Vec3<D>& to_corner, const RayLanes<D>& ray,
                          TriangleMask<D>& mask) {
  const auto set = [&](float x) { return hn::Set(d, x); };
  const Vec3<D> r = Cross(to_corner, ray.direction);
  const V facing = Dot(triangle.normal, ray.direction);
  const V v = Dot(r, triangle.edge2), w = hn::Neg(Dot(r, triangle.edge1));
  const V rest = hn::Sub(hn::Sub(facing, v), w);
  const V facing_error = hn::MulAdd(triangle.area, set(relative_facing_error), set(underflow_error));
  const V edge_error = hn::MulAdd(triangle.edges, ray.edge_error, facing_error);
  const V least = hn::Min(v, hn::Min(w, rest)), most = hn::Max(v, hn::Max(w, rest));
  auto maybe = hn::Or(hn::Ge(least, hn::Neg(edge_error)), hn::Le(most, edge_error));
  if (hn::AllFalse(d, maybe)) return false;

  // Edge-on, nothing is known about distances.
  const V height = Dot(triangle.normal, to_corner), steep = hn::Abs(facing);
  const V ahead = hn::Xor(height, hn::And(facing, hn::SignBit(d)));
  const V height_error = hn::MulAdd(triangle.area, ray.height_error, set(underflow_error));
  const auto is_clear = hn::Gt(steep, hn::Add(facing_error, facing_error));
  const V low = hn::Sub(ahead, height_error), high = hn::Add(ahead, height_error);
  const V wide = hn::Add(steep, facing_error), narrow = hn::Sub(steep, facing_error);
  // The division may round by u; so may the following operations.
  const V nearest = hn::Mul(hn::Div(low, hn::IfThenElse(hn::Ge(low, hn::Zero(d)), wide, narrow)), set(rounded_down));
  const auto is_far = hn::Gt(nearest, ray.limit), is_behind = hn::Lt(high, hn::Zero(d));
  maybe = hn::AndNot(hn::And(is_clear, hn::Or(is_far, is_behind)), maybe);
  if (hn::AllFalse(d, maybe)) return false;
  const auto is_inside = hn::Or(hn::Gt(least, edge_error), hn::Lt(most, hn::Neg(edge_error)));
  const auto is_in_front = hn::Gt(nearest, ray.certain_from);
  mask.maybe = maybe;
  mask.certain = hn::And(maybe, hn::And(is_clear, hn::And(is_inside, is_in_front)));
  mask.nearest = hn::IfThenElseZero(is_clear, nearest);
  mask.farthest = hn::Mul(hn::Div(high, narrow), set(rounded_up));
  return true;
}

/// Returns the lanes that are set, as bits.
template <typename D, typename M>
HWY_INLINE std::uint32_t Bits(D d, M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// The masks of a block's triangles as bits, and their distances in arrays.
struct BlockMask {
  std::uint32_t maybe = 0, certain = 0;
  alignas(32) float nearest[width], farthest[width];
};

/// Tests one ray, a TraversalRay or one of a packet, against the triangles of a block.
template <typename RayInBoxes>
HWY_INLINE void TestTriangles(const TriangleBlock& block, const RayInBoxes& ray, float limit, BlockMask& mask) {
  const Lanes d;
  const auto set = [&](float x) { return hn::Set(d, x); };
  mask.maybe = mask.certain = 0;
  for (std::size_t i = 0; i < width; i += hn::Lanes(d)) {
    const RayLanes<Lanes> rays{Broadcast(d, ray.direction), set(ray.certain_from), set(ray.edge_error),
                               set(ray.height_error), set(limit)};
    const Vec3<Lanes> to_corner = LoadEach(d, block.corner, i) - Broadcast(d, ray.origin);
    TriangleMask<Lanes> lanes;
    if (!TestLanes(d, LoadTriangles(d, block, i), to_corner, rays, lanes)) continue;
    hn::Store(lanes.nearest, d, mask.nearest + i);
    hn::Store(lanes.farthest, d, mask.farthest + i);
    mask.maybe |= Bits(d, lanes.maybe) << i;
    mask.certain |= Bits(d, lanes.certain) << i;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
