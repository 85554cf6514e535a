// What all structures do with what they find: included once for each instruction set.

#if defined(RAY_ACCELERATE_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_SEARCH_INL_H_
#undef RAY_ACCELERATE_SEARCH_INL_H_
#else
#define RAY_ACCELERATE_SEARCH_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstring>
#include <limits>
#include <optional>

#include "R3/Mesh.h"
#include "R3/Triangle.h"
#include "source/accelerate/NearestHit.h"
#include "source/accelerate/twolevel/TwoLevel.h"

// Where single precision may err, it errs on the side of asking. All coordinates are the structure's, so at most 1 in
// boxes and triangles; directions are scaled so that their largest component lies in [1, 2); u is 2^-24. With r = 1 +
// the largest coordinate of the ray's origin:
//   - A plane rounded to float is off by u/2, the origin by u r, their product with 1/d by u r, 1/d itself (with d
//     rounded before) by 2 u of the distance, at most 2 u r, the difference by u r: together less than 8 u r in terms
//     of where the plane is. So each ray moves all planes outward by 8 u r: that is its slack.
//   - With |e| the sum of magnitudes of an edge's components: corner - origin is off by 2 u r and at most r in each, so
//     R = (corner - origin) x d, at most 4 r, is off by 20 u r in each, R . e by (20 + 12 + 4) u r |e|. The normal n is
//     off by 5 u |e1| |e2| in each component, n . d by 32 u |e1| |e2|, n . (corner - origin) by 16 u r |e1| |e2|.
//   - What doubles lose is 2^-50 of the origin's distance before it was moved near; 2^-20 u of it is in r.
// So a triangle whose edge functions are all positive by more than their slack is hit for certain, by the doubles too;
// its distance then is known between two bounds, of which the upper one already ends the search. Doubles decide about
// the few that remain in the end.
HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, width>;
using Floats = hn::Vec<Lanes>;

inline constexpr float u = 0x1p-24f;

// What exactness costs is measured by doing without (script/price_of_contract.sh); never built so otherwise.
#if defined(RAYPRO_WITHOUT_DOUBLES)
inline constexpr bool doubles_decide = false;
#else
inline constexpr bool doubles_decide = true;
#endif
// The slacks above: of planes, times r; of edge functions, times r (|e1| + |e2|), 36 u and something for the sums of
// slacks themselves; of n . (corner - origin), times (r + 1) |e1| |e2|; of n . d, times |e1| |e2|.
inline constexpr float plane_slack = 8 * u, edge_slack = 40 * u, height_slack = 16 * u, facing_slack = 32 * u;
/// What triangles' slacks have besides, for products below the normal range of floats, 2^-126. An edge function has
/// some 30 terms, each off by at most 2^-126 if such products became 0, times at most 4 for what it is multiplied with
/// later: together less than 2^-119. A height has the corner as a factor, which may be large; but heights count only
/// where n . d is above twice this, and there |e1| |e2| is above 2^-101, so that what is lost, 2^-149 r at most for
/// each component of n, is far less than the height's own slack.
inline constexpr float underflow_slack = 0x1p-99f;
/// So much of the distance that a ray came from is added to r, for what doubles lose on the way.
inline constexpr double slack_of_moving = 0x1p-20;
/// Computed distances times these are bounds, where a division or a conversion rounds, and so does the product.
inline constexpr float rounded_up = 1 + 4 * u, rounded_down = 1 - 4 * u;
#if defined(RAYPRO_WITHOUT_PADS)
inline constexpr float pad_of_boxes = 0;
#else
inline constexpr float pad_of_boxes = plane_slack;
#endif

/// Rays begin where they are when their origin is no farther, in half boxes: that makes r, and so the slack, at most 7
/// times what it is inside, and saves finding where they enter.
inline constexpr double near_enough = 6;
/// Above these, and below 1 over them, products of doubles leave their range, and what is certain in a structure's
/// coordinates need not be found in the scene's.
inline constexpr double most_scale = 0x1p200, most_per_t = 0x1p700;
/// No direction is nearer to being along a plane: that moves rays by less than their slack, and keeps products finite.
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
HWY_INLINE auto Largest(const V& v) {
  const auto larger = [](auto a, auto b) {
    return a > b ? a : b;
  };  // values, so that it is an instruction, not a branch
  return larger(larger(std::abs(v[0]), std::abs(v[1])), std::abs(v[2]));
}

/// A ray in a structure's coordinates, begun where it enters the structure's box if it comes from afar.
struct TraversalRay {
  Double4 start, along;  // where it begins, and its direction
  Float4 origin, direction, inverse;
  Float4 near_shift, far_shift;  // (origin +- slack) * inverse
  Whole4 signs;                  // below 0 where the direction is
  float slack;
  float slack_of_edges;   // times |e1| + |e2|
  float slack_of_height;  // times |e1| |e2|
  double per_t, begin;    // distance along the probe = t * per_t - begin
  bool is_lost = false;   // it misses the structure's box

  TraversalRay() = default;

  /// An upper bound.
  float Distance(double t) const { return static_cast<float>(t * per_t - begin) * rounded_up + slack; }

  HWY_INLINE TraversalRay(const Coordinates& place, double pad_per_distance, const R3::Ray& ray,
                          double distance_in_world) {
    static_assert(sizeof(R3::Ray) >= 8 * sizeof(double) && sizeof(R3::Point) == 3 * sizeof(double));
    const Double4 center{place.center.x, place.center.y, place.center.z, 0};
    Double4 eye, heading;
    Load(&ray.origin.x, eye), Load(&ray.direction.x, heading);
    const Double4 from = place.scale * (eye - center);
    const double power = PowerOfTwoBelowInverse(Largest(heading));
    along = power * heading;
    per_t = place.scale * InverseOfPowerOfTwo(power);

    // Enter the box, generously, so that the coordinates are no larger than they need be.
    const double far = Largest(from);
    const double more = pad_per_distance * distance_in_world * place.scale;
    begin = ray.t_min == 0 ? 0 : ray.t_min * per_t;
    if (HWY_UNLIKELY(far > near_enough + more)) {
      const double reach = 1 + 0x1p-10 + 0x1p-40 * far + more;
      double enter = begin, leave = ray.t_max * per_t;
      for (int axis = 0; axis < 3; ++axis) {
        const double a = (-reach - from[axis]) / along[axis], b = (reach - from[axis]) / along[axis];
        enter = std::max(enter, std::min(a, b));  // a NaN, from a ray in the plane, leaves things as they were
        leave = std::min(leave, std::max(a, b));
      }
      if (enter > leave * (1 + 0x1p-40) + 0x1p-40 * far) {
        is_lost = true;
        return;
      }
      begin = enter;
    }
    const bool is_in_range = std::abs(begin) < 0x1p1000 && per_t < most_per_t && per_t > 1 / most_per_t &&
                             place.scale <= most_scale && place.scale >= 1 / most_scale;
    start = begin == 0 ? from : from + begin * along;
    const double origin_reach =
        1 + Largest(start) + slack_of_moving * (far + std::abs(begin)) + more * (1 / plane_slack);
    const float r = static_cast<float>(origin_reach);
    slack = pad_of_boxes * r;
    slack_of_edges = edge_slack * r;
    slack_of_height = height_slack * (r + 1);
    origin = __builtin_convertvector(start, Float4);
    direction = __builtin_convertvector(along, Float4);
    signs = std::bit_cast<Whole4>(direction);
    const Whole4 sign = signs & std::bit_cast<std::int32_t>(-0.0f);
    const Float4 steepness = std::bit_cast<Float4>(signs ^ sign), flat = Float4{} + flattest;
    const Float4 steep = std::bit_cast<Float4>(std::bit_cast<Whole4>(steepness > flat ? steepness : flat) | sign);
    inverse = 1 / steep;
    const Float4 outward = std::bit_cast<Float4>(std::bit_cast<Whole4>(Float4{} + slack) | sign);
    near_shift = (origin + outward) * inverse;
    far_shift = (origin - outward) * inverse;
    if (HWY_UNLIKELY(!is_in_range || !(origin_reach < most_reach))) AskEverything();
  }

 private:
  /// Where single precision cannot tell one place from another.
  void AskEverything() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    slack = slack_of_edges = slack_of_height = infinity;
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
  V direction_x, direction_y, direction_z, slack, slack_of_edges, slack_of_height, limit;
};

/// What lanes may have of each other.
template <typename D>
struct TriangleMask {
  hn::Mask<D> maybe, certain;  // the certain ones are in maybe too
  hn::Vec<D> nearest;          // bounds on the distance; of those that are not clear 0
  hn::Vec<D> farthest;         // of the certain
};

/// Which triangles are not certainly missed by their ray before its limit; false when none, and then no more is said.
///   to_corner   from the ray's origin to the triangle's first corner
///   source      the edge functions of Moller, Trumbore, Fast, minimum storage ray/triangle intersection (1997),
///               undivided
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE bool TestLanes(D d, const TriangleLanes<D>& triangle, V cx, V cy, V cz, const RayLanes<D>& ray,
                          TriangleMask<D>& verdict) {
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
  const V slack_of_facing = hn::MulAdd(triangle.area, set(facing_slack), set(underflow_slack));
  const V slack = hn::MulAdd(triangle.edges, ray.slack_of_edges, slack_of_facing);
  const V least = hn::Min(v, hn::Min(w, rest)), most = hn::Max(v, hn::Max(w, rest));
  auto maybe = hn::Or(hn::Ge(least, hn::Neg(slack)), hn::Le(most, slack));
  if (hn::AllFalse(d, maybe)) return false;

  // Edge-on, nothing is known of distances.
  const V height = dot(triangle.normal_x, triangle.normal_y, triangle.normal_z, cx, cy, cz), steep = hn::Abs(facing);
  const V ahead = hn::Xor(height, hn::And(facing, hn::SignBit(d)));
  const V slack_of_height = hn::MulAdd(triangle.area, ray.slack_of_height, set(underflow_slack));
  const auto is_clear = hn::Gt(steep, hn::Add(slack_of_facing, slack_of_facing));
  const V low = hn::Sub(ahead, slack_of_height), high = hn::Add(ahead, slack_of_height);
  const V wide = hn::Add(steep, slack_of_facing), narrow = hn::Sub(steep, slack_of_facing);
  // Dividing may round by u; so may what follows.
  const V nearest = hn::Mul(hn::Div(low, hn::IfThenElse(hn::Ge(low, hn::Zero(d)), wide, narrow)), set(rounded_down));
  const auto is_far = hn::Gt(nearest, ray.limit), is_behind = hn::Lt(high, hn::Zero(d));
  maybe = hn::AndNot(hn::And(is_clear, hn::Or(is_far, is_behind)), maybe);
  if (hn::AllFalse(d, maybe)) return false;
  const auto is_inside = hn::Or(hn::Gt(least, slack), hn::Lt(most, hn::Neg(slack)));
  const auto is_in_front = hn::Gt(nearest, ray.slack);
  verdict.maybe = maybe;
  verdict.certain = hn::And(maybe, hn::And(is_clear, hn::And(is_inside, is_in_front)));
  verdict.nearest = hn::IfThenElseZero(is_clear, nearest);
  verdict.farthest = hn::Mul(hn::Div(high, narrow), set(rounded_up));
  return true;
}

/// The lanes that are set, as bits.
template <typename D, typename M>
HWY_INLINE std::uint32_t Bits(D d, M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// What a block of triangles may have for a probe: TriangleMask, the lanes being bits and places in arrays.
struct Possible {
  std::uint32_t maybe = 0, certain = 0;
  alignas(32) float nearest[width], farthest[width];
};

HWY_INLINE void TestTriangles(const TriangleBlock& block, const TraversalRay& probe, float limit, Possible& possible) {
  const Lanes lanes;
  const auto set = [&](float x) { return hn::Set(lanes, x); };
  possible.maybe = possible.certain = 0;
  for (std::size_t i = 0; i < width; i += hn::Lanes(lanes)) {
    const auto to_corner = [&](int axis) {
      return hn::Sub(hn::Load(lanes, block.corner[axis] + i), set(probe.origin[axis]));
    };
    const RayLanes<Lanes> ray{set(probe.direction[0]),
                              set(probe.direction[1]),
                              set(probe.direction[2]),
                              set(probe.slack),
                              set(probe.slack_of_edges),
                              set(probe.slack_of_height),
                              set(limit)};
    TriangleMask<Lanes> verdict;
    if (!TestLanes(lanes, LoadTriangles(lanes, block, i), to_corner(0), to_corner(1), to_corner(2), ray, verdict))
      continue;
    hn::Store(verdict.nearest, lanes, possible.nearest + i);
    hn::Store(verdict.farthest, lanes, possible.farthest + i);
    possible.maybe |= Bits(lanes, verdict.maybe) << i;
    possible.certain |= Bits(lanes, verdict.certain) << i;
  }
}

template <bool any, typename Structure>
bool Search(const TwoLevel<Structure>& forest, const Structure& structure, const R3::Ray& ray, double distance_in_world,
            std::optional<std::uint32_t> instance, NearestHit& nearest, Counts& counts);

/// Decides in doubles about triangles of one structure, for one ray.
template <typename Structure>
class ExactTriangleTest {
 public:
  struct Place {
    const R3::Mesh* mesh;
    std::uint32_t instance;
    std::int32_t element;

    const std::array<std::uint32_t, 3>& Indices() const {
      return mesh->Data().triangles[static_cast<std::size_t>(element)];
    }
    void FetchIndices() const { __builtin_prefetch(&Indices()); }
    /// Once the indices are there.
    void FetchCorners() const {
      for (const std::uint32_t corner : Indices()) __builtin_prefetch(&mesh->Data().positions[corner]);
    }
  };

  HWY_INLINE ExactTriangleTest(const TwoLevel<Structure>& forest, const Structure& structure, const R3::Ray& ray,
                               std::optional<std::uint32_t> instance, NearestHit& nearest, Counts& counts)
      : forest_(forest), space_(structure.space), instance_(instance), nearest_(nearest), counts_(counts), ray_(ray) {}

  /// Makes the ray ready ahead of time, so that its division is over when it is needed.
  HWY_INLINE void Prepare() { sheared_.emplace(ray_); }

  HWY_INLINE Place Find(std::uint32_t item) const {
    const PrimRef what = space_[item];
    const std::uint32_t of = instance_.value_or(what.instance);
    return {forest_.world->Instances()[of].mesh, of, what.element};
  }

  HWY_FLATTEN bool Decide(const Place& place) {
    if (!sheared_) Prepare();
    if (nearest_.Best()) sheared_->t_max = std::min(sheared_->t_max, R3::NextUp(nearest_.Limit()));
    ++counts_.primitive_tests;
    const auto hit = R3::IntersectTriangleInline(*sheared_, place.mesh->Corners(place.element));
    if (!hit) return false;
    nearest_.Offer({*hit, place.instance, place.element});
    return true;
  }

 private:
  const TwoLevel<Structure>& forest_;
  const PrimitiveSet& space_;
  std::optional<std::uint32_t> instance_;
  NearestHit& nearest_;
  Counts& counts_;
  const R3::Ray& ray_;
  std::optional<R3::ShearedRay> sheared_;
};

/// Asks an item that is no triangle of the structure's frame; true when there is a hit of `any`.
template <bool any, typename Structure>
bool AskItem(const TwoLevel<Structure>& forest, const Structure& structure, std::uint32_t item, const R3::Ray& ray,
             double distance_in_world, NearestHit& nearest, Counts& counts) {
  const PrimRef what = structure.space[item];
  const Instance& instance = forest.world->Instances()[what.instance];
  const R3::Ray local = instance.frame == 0 ? ray : forest.world->Back(instance.frame, ray);
  if (what.element == PrimRef::whole)
    return Search<any>(forest, forest.structures[static_cast<std::size_t>(instance.shared) + 1], local,
                       distance_in_world, what.instance, nearest, counts) ||
           (any && nearest.Best());
  nearest.Test(what.instance, what.element, local, counts);
  return any && nearest.Best();
}

/// Asks what a walk comes by. Triangles that doubles may have to decide about are kept until the end; where their
/// corners are in memory is looked up in steps while the walk goes on, so that deciding need not wait for it.
template <bool any, typename Structure>
class LeafVisitor {
 public:
  HWY_INLINE LeafVisitor(const TwoLevel<Structure>& forest, const Structure& structure, const R3::Ray& ray,
                         const TraversalRay& probe, double distance_in_world, std::optional<std::uint32_t> instance,
                         NearestHit& nearest, Counts& counts)
      : limit(probe.Distance(nearest.Limit())),
        forest_(forest),
        structure_(structure),
        ray_(ray),
        probe_(probe),
        distance_in_world_(distance_in_world),
        nearest_(nearest),
        counts_(counts),
        limit_for_certain_(limit - 4 * probe.slack),
        decider_(forest, structure, ray, instance, nearest, counts) {
    if constexpr (!any) decider_.Prepare();
  }

  float limit;               // what is farther along the probe than this is not wanted any more
  bool is_answered = false;  // of `any`: there is a hit

  /// True when that ends the search.
  HWY_INLINE bool AskBlock(const TriangleBlock& block) {
    Possible possible;
    TestTriangles(block, probe_, limit, possible);
    if constexpr (!doubles_decide) possible.maybe = possible.certain;
    for (std::uint32_t rest = possible.maybe; rest; rest &= rest - 1) {
      const int i = std::countr_zero(rest);
      const bool is_certain = possible.certain >> i & 1;
      if constexpr (any) {
        is_answered =
            (is_certain && possible.farthest[i] < limit_for_certain_) || decider_.Decide(decider_.Find(block.item[i]));
        if (is_answered) return true;
      } else {
        constexpr float none = std::numeric_limits<float>::infinity();
        Keep(block.item[i], possible.nearest[i], is_certain ? possible.farthest[i] : none);
      }
    }
    return false;
  }

  /// The same for an item of another kind.
  bool AskItem(std::uint32_t item) {
    Finish();
    is_answered = HWY_NAMESPACE::AskItem<any>(forest_, structure_, item, ray_, distance_in_world_, nearest_, counts_);
    if constexpr (any) return is_answered;
    limit = std::min(limit, probe_.Distance(nearest_.Limit()));
    return false;
  }

  /// Decides about the triangles kept that may still be the nearest, last found first.
  HWY_INLINE void Finish() {
    if (count_ == 0) return;
    for (int i = 0; i + 1 < count_; ++i) kept_[i].place.FetchCorners();
    while (count_ > 0) {
      --count_;
      if (!doubles_decide && kept_[count_].nearest <= limit) {
        const double t = (static_cast<double>(kept_[count_].nearest) + probe_.begin) / probe_.per_t;
        nearest_.Offer({{t, 0, 0, 0}, kept_[count_].place.instance, kept_[count_].place.element});
        limit = kept_[count_].nearest;
      } else if (kept_[count_].nearest <= limit && decider_.Decide(kept_[count_].place))
        limit = std::min(limit, probe_.Distance(nearest_.Limit()));
    }
  }

 private:
  struct GpuCache {
    std::uint32_t item;
    float nearest;
    typename ExactTriangleTest<Structure>::Place place;
  };
  static constexpr int most = 16;

  HWY_INLINE void Keep(std::uint32_t item, float nearest, float farthest) {
    if constexpr (Structure::meets_items_again)
      if (count_ > 0 && kept_[count_ - 1].item == item) return;
    if (count_ == most) Finish();
    kept_[count_] = {item, nearest, decider_.Find(item)};
    kept_[count_].place.FetchIndices();
    ++count_;
    limit = std::min(limit, farthest);
  }

  const TwoLevel<Structure>& forest_;
  const Structure& structure_;
  const R3::Ray& ray_;
  const TraversalRay& probe_;
  double distance_in_world_;
  NearestHit& nearest_;
  Counts& counts_;
  float limit_for_certain_;
  ExactTriangleTest<Structure> decider_;
  int count_ = 0;
  GpuCache kept_[most];
};

/// Through one structure; `instance` is the shared mesh's whose inside it is. True when `any` is answered. Each
/// structure brings a Walk of its own, which asks until Ask... returns true or nothing is left before the limit.
template <bool any, typename Structure>
bool Search(const TwoLevel<Structure>& forest, const Structure& structure, const R3::Ray& ray, double distance_in_world,
            std::optional<std::uint32_t> instance, NearestHit& nearest, Counts& counts) {
  const TraversalRay probe(structure.coordinates, structure.space.PadPerDistance(), ray, distance_in_world);
  if (probe.is_lost) return false;
  LeafVisitor<any, Structure> asker(forest, structure, ray, probe, distance_in_world, instance, nearest, counts);
  Walk<any>(structure, probe, asker, counts);
  asker.Finish();
  return asker.is_answered;
}

template <typename Structure>
void FindNearest(const TwoLevel<Structure>& forest, const R3::Ray& ray, NearestHit& nearest, Counts& counts) {
  Search<false>(forest, forest.structures[0], ray, MaxComponent(Abs(FromOrigin(ray.origin))), std::nullopt, nearest,
                counts);
}

template <typename Structure>
bool FindAny(const TwoLevel<Structure>& forest, const R3::Ray& ray, Counts& counts) {
  NearestHit nearest(*forest.world, ray);
  return Search<true>(forest, forest.structures[0], ray, MaxComponent(Abs(FromOrigin(ray.origin))), std::nullopt,
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
