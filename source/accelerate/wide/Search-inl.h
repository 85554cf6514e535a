// Tests of triangles and of other primitives that a traversal comes by, and of rays against whole structures: included
// once for each instruction set.

#if defined(RAY_ACCELERATE_WIDE_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_SEARCH_INL_H_
#undef RAY_ACCELERATE_WIDE_SEARCH_INL_H_
#else
#define RAY_ACCELERATE_WIDE_SEARCH_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstring>
#include <limits>
#include <optional>

#include "R3/Mesh.h"
#include "R3/Sphere.h"
#include "R3/Triangle.h"
#include "source/accelerate/NearestHit.h"
#include "source/accelerate/twolevel/TwoLevel.h"

// Traversal is watertight and conservative: where single precision may err, it errs on the side of testing once more in
// double precision. All coordinates are the structure's, so at most 1 in
// boxes and triangles; directions are scaled so that their largest component lies in [1, 2); u is 2^-24. With r = 1 +
// the largest coordinate of the ray's origin:
//   - A plane rounded to float is off by u/2, the origin by u r, their product with 1/d by u r, 1/d itself (with d
//     rounded before) by 2 u of the distance, at most 2 u r, the difference by u r: together less than 8 u r in terms
//     of where the plane is. So each ray moves all planes outward by 8 u r: its plane error bound.
//   - With |e| the sum of magnitudes of an edge's components: corner - origin is off by 2 u r and at most r in each, so
//     R = (corner - origin) x d, at most 4 r, is off by 20 u r in each, R . e by (20 + 12 + 4) u r |e|. The normal n is
//     off by 5 u |e1| |e2| in each component, n . d by 32 u |e1| |e2|, n . (corner - origin) by 16 u r |e1| |e2|.
//   - What doubles lose is 2^-50 of the origin's distance before it was moved near; 2^-20 u of it is in r.
// So a triangle whose edge functions (its barycentric coordinates, undivided) all exceed their error bound is hit for
// certain, by the exact test too; its distance then is known between two bounds, of which the upper one already ends
// the search. The exact test in doubles decides about the few candidates that remain in the end.
HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, width>;
using Floats = hn::Vec<Lanes>;

inline constexpr float u = 0x1p-24f;

// The bounds above: of planes, times r; of edge functions, times r (|e1| + |e2|), 36 u and something for sums of the
// bounds themselves; of n . (corner - origin), times (r + 1) |e1| |e2|; of n . d, times |e1| |e2|.
inline constexpr float relative_plane_error = 8 * u, relative_edge_error = 40 * u, relative_height_error = 16 * u,
                       relative_facing_error = 32 * u;
/// What the error bounds of triangles have besides, for products below the normal range of floats, 2^-126. An edge
/// function has some 30 terms, each off by at most 2^-126 if such products became 0, times at most 4 for what it is
/// multiplied with later: together less than 2^-119. A height has the corner as a factor, which may be large; but
/// heights count only where n . d is above twice this, and there |e1| |e2| is above 2^-101, so that what is lost,
/// 2^-149 r at most for each component of n, is far less than the height's own bound.
inline constexpr float underflow_error = 0x1p-99f;
/// So much of the distance that a ray came from is added to r, for what doubles lose on the way.
inline constexpr double translation_error = 0x1p-20;
/// Computed distances times these are bounds, where a division or a conversion rounds, and so does the product.
inline constexpr float rounded_up = 1 + 4 * u, rounded_down = 1 - 4 * u;

/// Rays begin where they are when their origin is no farther, in half boxes: that makes r, and so the error bounds, at
/// most 7 times what they are inside, and saves finding where they enter.
inline constexpr double near_enough = 6;
/// Above these, and below 1 over them, products of doubles leave their range, and what is certain in a structure's
/// coordinates need not be found in the scene's.
inline constexpr double most_scale = 0x1p200, most_per_t = 0x1p700;
/// No direction is nearer to being along a plane: that moves rays by less than their error bound, and keeps products
/// finite.
inline constexpr float flattest = 0x1p-40f;
/// Single precision cannot tell one place from another long before r is so large; and r / flattest is still finite.
inline constexpr double most_reach = 0x1p60;

/// 2^-e for the x in [2^e, 2^(e+1)), which must be finite and not 0; at least 2^-1022 and at most 2^1022.
HWY_INLINE double PowerOfTwoBelowInverse(double x) {
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff;
  return std::bit_cast<double>(std::clamp<std::uint64_t>(2046 - exponent, 1, 2045) << 52);
}
/// 1 / x of a power of two that the above gave.
HWY_INLINE double InverseOfPowerOfTwo(double x) {
  return std::bit_cast<double>((std::uint64_t{2046} << 52) - std::bit_cast<std::uint64_t>(x));
}

// Four numbers at once, as the compilers know them; the fourth is whatever lies behind the third in memory.
using Double4 = double __attribute__((vector_size(32)));
using Float4 = float __attribute__((vector_size(16)));
using Whole4 = std::int32_t __attribute__((vector_size(16)));

HWY_INLINE void Load(const double* xyz, Double4& v) { std::memcpy(&v, xyz, sizeof v); }
template <typename V>
HWY_INLINE auto LargestOf(const V& v) {
  const auto larger = [](auto a, auto b) {
    return a > b ? a : b;
  };  // values, so that it is an instruction, not a branch
  return larger(larger(std::abs(v[0]), std::abs(v[1])), std::abs(v[2]));
}

/// A ray in a structure's coordinates, begun where it enters the structure's box if it comes from afar.
struct TraversalRay {
  Double4 start, along;  // where it begins, and its direction
  Float4 origin, direction, inverse;
  Float4 near_shift, far_shift;  // (origin +- plane_error) * inverse
  Whole4 signs;                  // below 0 where the direction is
  float plane_error;
  float edge_error;      // times |e1| + |e2|
  float height_error;    // times |e1| |e2|
  double per_t, begin;   // distance along this ray = t * per_t - begin
  bool is_lost = false;  // it misses the structure's box

  bool IsDownward(int axis) const { return signs[axis] < 0; }
  /// An upper bound.
  float Distance(double t) const { return static_cast<float>(t * per_t - begin) * rounded_up + plane_error; }

  HWY_INLINE TraversalRay(const Coordinates& coordinates, double padding_per_distance, const R3::Ray& ray,
                          double distance_in_world) {
    static_assert(sizeof(R3::Ray) >= 8 * sizeof(double) && sizeof(R3::Point) == 3 * sizeof(double));
    const Double4 center{coordinates.center.x, coordinates.center.y, coordinates.center.z, 0};
    Double4 eye, heading;
    Load(&ray.origin.x, eye), Load(&ray.direction.x, heading);
    const Double4 from = coordinates.scale * (eye - center);
    const double power = PowerOfTwoBelowInverse(LargestOf(heading));
    along = power * heading;
    per_t = coordinates.scale * InverseOfPowerOfTwo(power);

    const double far = LargestOf(from);
    const double padding = padding_per_distance * distance_in_world * coordinates.scale;
    begin = ray.t_min == 0 ? 0 : ray.t_min * per_t;
    if (HWY_UNLIKELY(far > near_enough + padding) && !EnterBox(from, far, padding, ray.t_max * per_t)) {
      is_lost = true;
      return;
    }
    const bool is_in_range = std::abs(begin) < 0x1p1000 && per_t < most_per_t && per_t > 1 / most_per_t &&
                             coordinates.scale <= most_scale && coordinates.scale >= 1 / most_scale;
    start = begin == 0 ? from : from + begin * along;
    const double reach =
        1 + LargestOf(start) + translation_error * (far + std::abs(begin)) + padding * (1 / relative_plane_error);
    SetErrorBounds(static_cast<float>(reach));
    Round();
    if (HWY_UNLIKELY(!is_in_range || !(reach < most_reach))) AcceptEverything();
  }

 private:
  /// Begins where the ray enters the structure's box, generously widened, so that coordinates are no larger than they
  /// need be; false when it misses the box.
  HWY_INLINE bool EnterBox(const Double4& from, double far, double padding, double leave) {
    const double reach = 1 + 0x1p-10 + 0x1p-40 * far + padding;
    double enter = begin;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (-reach - from[axis]) / along[axis], b = (reach - from[axis]) / along[axis];
      enter = std::max(enter, std::min(a, b));  // a NaN, from a ray in the plane, leaves things as they were
      leave = std::min(leave, std::max(a, b));
    }
    if (enter > leave * (1 + 0x1p-40) + 0x1p-40 * far) return false;
    begin = enter;
    return true;
  }

  HWY_INLINE void SetErrorBounds(float r) {
    plane_error = relative_plane_error * r;
    edge_error = relative_edge_error * r;
    height_error = relative_height_error * (r + 1);
  }

  /// To single precision, and what boxes are tested with.
  HWY_INLINE void Round() {
    origin = __builtin_convertvector(start, Float4);
    direction = __builtin_convertvector(along, Float4);
    signs = std::bit_cast<Whole4>(direction);
    const Whole4 sign = signs & std::bit_cast<std::int32_t>(-0.0f);
    const Float4 steepness = std::bit_cast<Float4>(signs ^ sign), flat = Float4{} + flattest;
    const Float4 steep = std::bit_cast<Float4>(std::bit_cast<Whole4>(steepness > flat ? steepness : flat) | sign);
    inverse = 1 / steep;
    const Float4 outward = std::bit_cast<Float4>(std::bit_cast<Whole4>(Float4{} + plane_error) | sign);
    near_shift = (origin + outward) * inverse;
    far_shift = (origin - outward) * inverse;
  }

  /// Where single precision cannot tell one place from another.
  void AcceptEverything() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    plane_error = edge_error = height_error = infinity;
    per_t = 1, begin = 0;
    origin = inverse = Float4{};
    near_shift = Float4{} + infinity, far_shift = -near_shift;
  }
};

/// Triangles in lanes, one each or all the same.
template <typename D>
struct TriangleLanes {
  using V = hn::Vec<D>;
  V edge1_x, edge1_y, edge1_z, edge2_x, edge2_y, edge2_z, normal_x, normal_y, normal_z;
  V edges, area;  // sum and product of the edges' magnitudes
};

/// From the edges of the block's triangles.
template <typename D>
HWY_INLINE TriangleLanes<D> LoadTriangles(D d, const TriangleBlock& block, std::size_t first) {
  using V = hn::Vec<D>;
  const V ax = hn::Load(d, block.edge1[0] + first), bx = hn::Load(d, block.edge2[0] + first);
  const V ay = hn::Load(d, block.edge1[1] + first), by = hn::Load(d, block.edge2[1] + first);
  const V az = hn::Load(d, block.edge1[2] + first), bz = hn::Load(d, block.edge2[2] + first);
  const auto minus = [](V p, V q, V r, V s) { return hn::MulSub(p, q, hn::Mul(r, s)); };
  const auto sum = [](V x, V y, V z) { return hn::Add(hn::Abs(x), hn::Add(hn::Abs(y), hn::Abs(z))); };
  const V a = sum(ax, ay, az), b = sum(bx, by, bz);
  return {ax,
          ay,
          az,
          bx,
          by,
          bz,
          minus(ay, bz, az, by),
          minus(az, bx, ax, bz),
          minus(ax, by, ay, bx),
          hn::Add(a, b),
          hn::Mul(a, b)};
}

/// Rays in lanes, one each or all the same.
template <typename D>
struct RayLanes {
  using V = hn::Vec<D>;
  V direction_x, direction_y, direction_z, plane_error, edge_error, height_error, limit;
};

/// Which lanes may hit, and where.
template <typename D>
struct TriangleMask {
  HWY_INLINE TriangleMask() {}  // one that compilers make for themselves is not compiled for the instruction set

  hn::Mask<D> maybe, certain;  // the certain ones are in maybe too
  hn::Vec<D> nearest;          // bounds on the distance; of those that are not clear 0
  hn::Vec<D> farthest;         // of the certain
};

/// Which triangles are not certainly missed by their ray before its limit; false when none, and then no more is said.
///   to_corner   from the ray's origin to the triangle's first corner
///   v, w, rest  the hit's barycentric coordinates times n . d
///   source      the edge functions of Moller, Trumbore, Fast, minimum storage ray/triangle intersection (1997),
///               undivided
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE bool TestLanes(D d, const TriangleLanes<D>& triangle, V cx, V cy, V cz, const RayLanes<D>& ray,
                          TriangleMask<D>& mask) {
  const auto set = [&](float x) { return hn::Set(d, x); };
  const auto minus = [](V p, V q, V r, V s) { return hn::MulSub(p, q, hn::Mul(r, s)); };
  const auto dot = [](V px, V py, V pz, V qx, V qy, V qz) {
    return hn::MulAdd(px, qx, hn::MulAdd(py, qy, hn::Mul(pz, qz)));
  };
  const V dx = ray.direction_x, dy = ray.direction_y, dz = ray.direction_z;
  const V rx = minus(cy, dz, cz, dy), ry = minus(cz, dx, cx, dz), rz = minus(cx, dy, cy, dx);
  const V facing = dot(triangle.normal_x, triangle.normal_y, triangle.normal_z, dx, dy, dz);
  const V v = dot(rx, ry, rz, triangle.edge2_x, triangle.edge2_y, triangle.edge2_z);
  const V w = hn::Neg(dot(rx, ry, rz, triangle.edge1_x, triangle.edge1_y, triangle.edge1_z));
  const V rest = hn::Sub(hn::Sub(facing, v), w);
  const V facing_error = hn::MulAdd(triangle.area, set(relative_facing_error), set(underflow_error));
  const V edge_error = hn::MulAdd(triangle.edges, ray.edge_error, facing_error);
  const V least = hn::Min(v, hn::Min(w, rest)), most = hn::Max(v, hn::Max(w, rest));
  auto maybe = hn::Or(hn::Ge(least, hn::Neg(edge_error)), hn::Le(most, edge_error));
  if (hn::AllFalse(d, maybe)) return false;

  // Edge-on, nothing is known of distances.
  const V height = dot(triangle.normal_x, triangle.normal_y, triangle.normal_z, cx, cy, cz), steep = hn::Abs(facing);
  const V ahead = hn::Xor(height, hn::And(facing, hn::SignBit(d)));
  const V height_error = hn::MulAdd(triangle.area, ray.height_error, set(underflow_error));
  const auto is_clear = hn::Gt(steep, hn::Add(facing_error, facing_error));
  const V low = hn::Sub(ahead, height_error), high = hn::Add(ahead, height_error);
  const V wide = hn::Add(steep, facing_error), narrow = hn::Sub(steep, facing_error);
  // Dividing may round by u; so may what follows.
  const V nearest = hn::Mul(hn::Div(low, hn::IfThenElse(hn::Ge(low, hn::Zero(d)), wide, narrow)), set(rounded_down));
  const auto is_far = hn::Gt(nearest, ray.limit), is_behind = hn::Lt(high, hn::Zero(d));
  maybe = hn::AndNot(hn::And(is_clear, hn::Or(is_far, is_behind)), maybe);
  if (hn::AllFalse(d, maybe)) return false;
  const auto is_inside = hn::Or(hn::Gt(least, edge_error), hn::Lt(most, hn::Neg(edge_error)));
  const auto is_in_front = hn::Gt(nearest, ray.plane_error);
  mask.maybe = maybe;
  mask.certain = hn::And(maybe, hn::And(is_clear, hn::And(is_inside, is_in_front)));
  mask.nearest = hn::IfThenElseZero(is_clear, nearest);
  mask.farthest = hn::Mul(hn::Div(high, narrow), set(rounded_up));
  return true;
}

/// The lanes that are set, as bits.
template <typename D, typename M>
HWY_INLINE std::uint32_t Bits(D d, M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// The same for the triangles of a block: the lanes as bits and places in arrays.
struct BlockMask {
  std::uint32_t maybe = 0, certain = 0;
  alignas(32) float nearest[width], farthest[width];
};

/// One ray, a TraversalRay or one of a packet, against the triangles of a block.
template <typename RayInBoxes>
HWY_INLINE void TestTriangles(const TriangleBlock& block, const RayInBoxes& ray, float limit, BlockMask& mask) {
  const Lanes d;
  const auto set = [&](float x) { return hn::Set(d, x); };
  mask.maybe = mask.certain = 0;
  for (std::size_t i = 0; i < width; i += hn::Lanes(d)) {
    const auto to_corner = [&](int axis) {
      return hn::Sub(hn::Load(d, block.corner[axis] + i), set(ray.origin[axis]));
    };
    const RayLanes<Lanes> rays{set(ray.direction[0]),
                               set(ray.direction[1]),
                               set(ray.direction[2]),
                               set(ray.plane_error),
                               set(ray.edge_error),
                               set(ray.height_error),
                               set(limit)};
    TriangleMask<Lanes> lanes;
    if (!TestLanes(d, LoadTriangles(d, block, i), to_corner(0), to_corner(1), to_corner(2), rays, lanes)) continue;
    hn::Store(lanes.nearest, d, mask.nearest + i);
    hn::Store(lanes.farthest, d, mask.farthest + i);
    mask.maybe |= Bits(d, lanes.maybe) << i;
    mask.certain |= Bits(d, lanes.certain) << i;
  }
}

template <bool any, typename Structure>
bool Search(const TwoLevel<Structure>& two_level, const Structure& structure, const R3::Ray& ray,
            double distance_in_world, std::optional<std::uint32_t> instance, NearestHit& nearest, Counts& counts);

/// The watertight ray/triangle test in double precision, for one ray and the triangles of one structure.
template <typename Structure>
class ExactTriangleTest {
 public:
  struct TriangleRef {
    const R3::Mesh* mesh;
    std::uint32_t instance;
    std::int32_t element;
    std::int64_t primitive;  // as the world numbers them

    const std::array<std::uint32_t, 3>& Indices() const {
      return mesh->Data().triangles[static_cast<std::size_t>(element)];
    }
    void PrefetchIndices() const { __builtin_prefetch(&Indices()); }
    /// Once the indices are there.
    void PrefetchCorners() const {
      for (const std::uint32_t corner : Indices()) __builtin_prefetch(&mesh->Data().positions[corner]);
    }
  };

  HWY_INLINE ExactTriangleTest(const TwoLevel<Structure>& two_level, const Structure& structure, const R3::Ray& ray,
                               std::optional<std::uint32_t> instance, NearestHit& nearest, Counts& counts)
      : two_level_(two_level),
        primitives_(structure.primitives),
        instance_(instance),
        nearest_(nearest),
        counts_(counts),
        ray_(ray) {}

  HWY_INLINE TriangleRef Locate(std::uint32_t primitive) const {
    const PrimRef what = primitives_[primitive];
    const std::uint32_t of = instance_.value_or(what.instance);
    const Instance& instance = two_level_.world->Instances()[of];
    return {instance.mesh, of, what.element, instance.first_primitive + what.element};
  }

  HWY_FLATTEN bool Test(const TriangleRef& triangle) {
    if (triangle.primitive == ray_.leaving || triangle.primitive == ray_.reaching) return false;
    if (!sheared_) sheared_.emplace(ray_);  // most rays never ask
    if (nearest_.Best()) sheared_->t_max = std::min(sheared_->t_max, R3::NextUp(nearest_.Limit()));
    ++counts_.primitive_tests;
    const auto hit = R3::IntersectTriangleInline(*sheared_, triangle.mesh->CornersInPlace(triangle.element));
    if (!hit) return false;
    nearest_.Offer({*hit, triangle.instance, triangle.element});
    return true;
  }

 private:
  const TwoLevel<Structure>& two_level_;
  const PrimitiveSet& primitives_;
  std::optional<std::uint32_t> instance_;
  NearestHit& nearest_;
  Counts& counts_;
  const R3::Ray& ray_;
  std::optional<R3::ShearedRay> sheared_;
};

/// The sphere's own test, compiled for the instruction set. Whether there is a hit no farther than the nearest so far.
template <bool any>
HWY_NOINLINE HWY_FLATTEN bool TestSphere(const SphereLeaf& leaf, const R3::Ray& ray, NearestHit& nearest,
                                         Counts& counts) {
  if (leaf.primitive == ray.leaving || leaf.primitive == ray.reaching) return false;
  ++counts.primitive_tests;
  const auto hit = R3::IntersectSphereInline(ray, leaf.sphere, nearest.TMaxOf(ray));
  if (hit && !any) nearest.Offer({*hit, leaf.instance, 0});
  return hit.has_value();
}

/// Tests a primitive that is neither a triangle nor a sphere of the structure's frame: any other shape, or a whole
/// shared mesh. True when there is a hit of `any`.
template <bool any, typename Structure>
bool TestPrimitive(const TwoLevel<Structure>& two_level, const Structure& structure, std::uint32_t primitive,
                   const R3::Ray& ray, double distance_in_world, NearestHit& nearest, Counts& counts) {
  const PrimRef what = structure.primitives[primitive];
  const Instance& instance = two_level.world->Instances()[what.instance];
  if (what.element != PrimRef::whole && instance.IsEndOf(ray, what.element)) return false;
  std::optional<R3::Ray> there;
  const R3::Ray& local = instance.frame == 0 ? ray : there.emplace(two_level.world->Back(instance.frame, ray));
  if (what.element == PrimRef::whole)
    return Search<any>(two_level, two_level.structures[static_cast<std::size_t>(instance.shared) + 1], local,
                       distance_in_world, what.instance, nearest, counts) ||
           (any && nearest.Best());
  nearest.Test(what.instance, what.element, local, counts);
  return any && nearest.Best();
}

/// Tests what a traversal comes by. With `any`, an occlusion ray's, the first hit answers. Otherwise triangles that the
/// exact test may have to decide about are candidates until the end; where their corners are in memory is looked up in
/// steps while the traversal goes on, so that the exact test need not wait for it.
template <bool any, typename Structure, typename RayInBoxes = TraversalRay>
class LeafVisitor {
 public:
  HWY_INLINE LeafVisitor(const TwoLevel<Structure>& two_level, const Structure& structure, const R3::Ray& ray,
                         const RayInBoxes& traversal_ray, double distance_in_world,
                         std::optional<std::uint32_t> instance, NearestHit& nearest, Counts& counts)
      : limit(traversal_ray.Distance(nearest.Limit())),
        two_level_(two_level),
        structure_(structure),
        ray_(ray),
        traversal_ray_(traversal_ray),
        distance_in_world_(distance_in_world),
        nearest_(nearest),
        counts_(counts),
        limit_for_certain_(limit - 4 * traversal_ray.plane_error),
        exact_test_(two_level, structure, ray, instance, nearest, counts) {}

  float limit;               // what is farther along the traversal ray than this is not wanted any more
  bool is_answered = false;  // of `any`: there is a hit

  /// True when that ends the search.
  HWY_INLINE bool VisitTriangles(const TriangleBlock& block) {
    BlockMask mask;
    TestTriangles(block, traversal_ray_, limit, mask);
    for (std::uint32_t rest = mask.maybe; rest; rest &= rest - 1) {
      const int i = std::countr_zero(rest);
      const bool is_certain = mask.certain >> i & 1;
      if constexpr (any) {
        is_answered = (is_certain && mask.farthest[i] < limit_for_certain_) ||
                      exact_test_.Test(exact_test_.Locate(block.primitive[i]));
        if (is_answered) return true;
      } else {
        constexpr float none = std::numeric_limits<float>::infinity();
        Keep(block.primitive[i], mask.nearest[i], is_certain ? mask.farthest[i] : none);
      }
    }
    return false;
  }

  /// The same for a sphere.
  HWY_INLINE bool VisitSphere(const SphereLeaf& leaf) {
    if (!TestSphere<any>(leaf, ray_, nearest_, counts_)) return false;
    if constexpr (any) return is_answered = true;
    limit = std::min(limit, traversal_ray_.Distance(nearest_.Limit()));
    return false;
  }

  /// The same for a primitive of another kind.
  bool VisitPrimitive(std::uint32_t primitive) {
    if constexpr (!any) TestCandidatesNow();
    is_answered = TestPrimitive<any>(two_level_, structure_, primitive, ray_, distance_in_world_, nearest_, counts_);
    if constexpr (any) return is_answered;
    limit = std::min(limit, traversal_ray_.Distance(nearest_.Limit()));
    return false;
  }

  /// Decides about the candidates that may still be the nearest, last found first.
  HWY_INLINE void TestCandidates() {
    if (count_ == 0) return;
    for (int i = 0; i + 1 < count_; ++i) candidates_[i].triangle.PrefetchCorners();
    while (count_ > 0) {
      --count_;
      if (candidates_[count_].nearest <= limit && exact_test_.Test(candidates_[count_].triangle))
        limit = std::min(limit, traversal_ray_.Distance(nearest_.Limit()));
    }
  }

 private:
  struct Candidate {
    std::uint32_t primitive;
    float nearest;
    typename ExactTriangleTest<Structure>::TriangleRef triangle;
  };
  static constexpr int most_candidates = 16;

  /// Out of line where it is rare: the kernels are compiled many times.
  HWY_NOINLINE void TestCandidatesNow() { TestCandidates(); }

  HWY_INLINE void Keep(std::uint32_t primitive, float nearest, float farthest) {
    if constexpr (Structure::meets_primitives_again)
      if (count_ > 0 && candidates_[count_ - 1].primitive == primitive) return;
    if (count_ == most_candidates) TestCandidatesNow();
    const auto triangle = exact_test_.Locate(primitive);
    if (triangle.primitive == ray_.leaving) return;
    candidates_[count_] = {primitive, nearest, triangle};
    candidates_[count_].triangle.PrefetchIndices();
    ++count_;
    limit = std::min(limit, farthest);
  }

  const TwoLevel<Structure>& two_level_;
  const Structure& structure_;
  const R3::Ray& ray_;
  const RayInBoxes& traversal_ray_;
  double distance_in_world_;
  NearestHit& nearest_;
  Counts& counts_;
  float limit_for_certain_;
  ExactTriangleTest<Structure> exact_test_;
  int count_ = 0;
  Candidate candidates_[most_candidates];
};

/// Through one structure; `instance` is the shared mesh's whose inside it is. True when `any` is answered. Each
/// structure brings a Traverse of its own, which visits leaves until Visit... returns true or nothing is left before
/// the limit.
template <bool any, typename Structure>
bool Search(const TwoLevel<Structure>& two_level, const Structure& structure, const R3::Ray& ray,
            double distance_in_world, std::optional<std::uint32_t> instance, NearestHit& nearest, Counts& counts) {
  const TraversalRay traversal_ray(structure.coordinates, structure.primitives.PaddingPerDistance(), ray,
                                   distance_in_world);
  if (traversal_ray.is_lost) return false;
  LeafVisitor<any, Structure> visitor(two_level, structure, ray, traversal_ray, distance_in_world, instance, nearest,
                                      counts);
  Traverse<any>(structure, traversal_ray, visitor, counts);
  if constexpr (!any) visitor.TestCandidates();
  return visitor.is_answered;
}

template <typename Structure>
void FindNearest(const TwoLevel<Structure>& two_level, const R3::Ray& ray, NearestHit& nearest, Counts& counts) {
  Search<false>(two_level, two_level.structures[0], ray, MaxComponent(Abs(FromOrigin(ray.origin))), std::nullopt,
                nearest, counts);
}

template <typename Structure>
bool FindAny(const TwoLevel<Structure>& two_level, const R3::Ray& ray, Counts& counts) {
  NearestHit nearest(*two_level.world, ray);
  return Search<true>(two_level, two_level.structures[0], ray, MaxComponent(Abs(FromOrigin(ray.origin))), std::nullopt,
                      nearest, counts);
}

template <typename Structure>
Kernels<Structure> CompiledKernels() {
  return {HWY_TARGET, &FindNearest<Structure>, &FindAny<Structure>, nullptr, nullptr};
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
