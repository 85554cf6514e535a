#include "source/accelerate/bvh/Kernels.h"

#include <bit>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>

#include "R3/Mesh.h"
#include "R3/Triangle.h"
#include "source/accelerate/bvh/Build.h"

// Highway compiles the rest of this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "source/accelerate/bvh/Kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Where single precision may err, it errs on the side of asking. All coordinates are the tree's, so at most 1 in boxes
// and triangles; directions are scaled so that their largest component lies in [1, 2); u is 2^-24. With r = 1 + the
// largest coordinate of the ray's origin:
//   - A plane rounded to float is off by u/2, the origin by u r, their product with 1/d by u r, 1/d itself (with d
//     rounded before) by 2 u of the distance, at most 2 u r, the difference by u r: together less than 8 u r in terms of
//     where the plane is. So each ray moves all planes outward by 8 u r: that is its slack.
//   - With |e| the sum of magnitudes of an edge's components: corner - origin is off by 2 u r and at most r in each, so
//     R = (corner - origin) x d, at most 4 r, is off by 20 u r in each, R . e by (20 + 12 + 4) u r |e|. The normal n is
//     off by 5 u |e1| |e2| in each component, n . d by 32 u |e1| |e2|, n . (corner - origin) by 16 u r |e1| |e2|.
//   - What doubles lose is 2^-50 of the origin's distance before it was moved near; 2^-20 u of it is in r.
// So a triangle whose edge functions are all positive by more than their slack is hit for certain, by the doubles too;
// its distance then is known between two bounds, of which the upper one already ends the search. Doubles decide about
// the few that remain in the end.
HWY_BEFORE_NAMESPACE();
namespace ray::bvh {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, width>;
using Floats = hn::Vec<Lanes>;

inline constexpr float u = 0x1p-24f;

/// 2^-e for the x in [2^e, 2^(e+1)), which must be finite and not 0; exact but for subnormal x.
HWY_INLINE double PowerOfTwoBelowInverse(double x) {
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff;
  return std::bit_cast<double>(std::clamp<std::uint64_t>(2046 - exponent, 1, 2045) << 52);
}

// Four numbers at once, as the compilers know them; the fourth is whatever lies behind the third in memory.
using Double4 = double __attribute__((vector_size(32)));
using Float4 = float __attribute__((vector_size(16)));
using Whole4 = std::int32_t __attribute__((vector_size(16)));

HWY_INLINE void Load(const double* xyz, Double4& v) { std::memcpy(&v, xyz, sizeof v); }
template <typename V>
HWY_INLINE auto Largest(const V& v) {
  return std::max(std::max(std::abs(v[0]), std::abs(v[1])), std::abs(v[2]));
}

/// A ray in a tree's coordinates, begun where it enters the tree's box if it comes from afar.
struct Probe {
  Float4 origin, direction, inverse;
  Float4 near_shift, far_shift;  // (origin +- slack) * inverse
  Whole4 signs;                  // below 0 where the direction is
  float slack;
  float slack_of_edges;          // times |e1| + |e2|
  float slack_of_height;         // times |e1| |e2|
  double per_t, begin;           // distance along the probe = t * per_t - begin
  bool is_lost = false;          // it misses the tree's box

  /// An upper bound.
  float Distance(double t) const { return static_cast<float>(t * per_t - begin) * (1 + 4 * u) + slack; }

  HWY_INLINE Probe(const Tree& tree, const R3::Ray& ray, double distance_in_world) {
    static_assert(sizeof(R3::Ray) == 8 * sizeof(double) && sizeof(R3::Point) == 3 * sizeof(double));
    const Double4 center{tree.center.x, tree.center.y, tree.center.z, 0};
    Double4 eye, heading;
    Load(&ray.origin.x, eye), Load(&ray.direction.x, heading);
    const Double4 from = tree.scale * (eye - center);
    const double power = PowerOfTwoBelowInverse(Largest(heading));
    const Double4 along = power * heading;
    per_t = tree.scale / power;

    // Enter the box, generously, so that the coordinates are no larger than they need be.
    const double far = Largest(from);
    const double more = tree.space.PadPerDistance() * distance_in_world * tree.scale;
    constexpr double near_enough = 6;
    begin = ray.t_min * per_t;
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
    if (!(std::abs(begin) < 0x1p1000)) begin = 0;
    const Double4 start = from + begin * along;
    const double origin_reach = 1 + Largest(start) + 0x1p-20 * (far + std::abs(begin)) + more * (1 / (8 * u));
    const float r = static_cast<float>(origin_reach);
    slack = 8 * u * r;
    slack_of_edges = 40 * u * r;
    slack_of_height = 16 * u * (r + 1);
    origin = __builtin_convertvector(start, Float4);
    direction = __builtin_convertvector(along, Float4);
    signs = std::bit_cast<Whole4>(direction);
    // Never quite along a plane: that moves the ray by less than the slack, and keeps all products finite.
    const Whole4 sign = signs & std::bit_cast<std::int32_t>(-0.0f);
    const Float4 steepness = std::bit_cast<Float4>(signs ^ sign), flat = Float4{} + 0x1p-40f;
    const Float4 steep = std::bit_cast<Float4>(std::bit_cast<Whole4>(steepness > flat ? steepness : flat) | sign);
    inverse = 1 / steep;
    const Float4 outward = std::bit_cast<Float4>(std::bit_cast<Whole4>(Float4{} + slack) | sign);
    near_shift = (origin + outward) * inverse;
    far_shift = (origin - outward) * inverse;
    if (HWY_UNLIKELY(!(origin_reach < 0x1p60))) AskEverything();
  }

 private:
  /// Where single precision cannot tell one place of the tree from another.
  void AskEverything() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    slack = slack_of_edges = slack_of_height = infinity;
    origin = inverse = Float4{};
    near_shift = Float4{} + infinity, far_shift = -near_shift;
  }
};

/// A probe ready for nodes: in registers while it walks.
struct BoxProbe {
  Floats inverse_x, inverse_y, inverse_z, near_x, near_y, near_z, far_x, far_y, far_z;
  std::uint32_t x, y, z;  // the near planes in Node::plane, in floats

  HWY_INLINE explicit BoxProbe(const Probe& p)
      : inverse_x(hn::Set(Lanes(), p.inverse[0])),
        inverse_y(hn::Set(Lanes(), p.inverse[1])),
        inverse_z(hn::Set(Lanes(), p.inverse[2])),
        near_x(hn::Set(Lanes(), p.near_shift[0])),
        near_y(hn::Set(Lanes(), p.near_shift[1])),
        near_z(hn::Set(Lanes(), p.near_shift[2])),
        far_x(hn::Set(Lanes(), p.far_shift[0])),
        far_y(hn::Set(Lanes(), p.far_shift[1])),
        far_z(hn::Set(Lanes(), p.far_shift[2])),
        x(p.signs[0] < 0 ? width : 0),
        y(2 * width + (p.signs[1] < 0 ? width : 0)),
        z(4 * width + (p.signs[2] < 0 ? width : 0)) {}

  /// Which children of a node are entered before `limit`, as bits; and where.
  HWY_INLINE std::uint32_t Test(const Node& node, float limit, float* HWY_RESTRICT entries) const {
    const Lanes lanes;
    const float* planes = node.plane[0];
    constexpr std::uint32_t other = width;  // low and high planes alternate: the far one is next door
    std::uint32_t reached = 0;
    for (std::size_t i = 0; i < width; i += hn::Lanes(lanes)) {
      const auto at = [&](std::uint32_t plane, Floats inverse, Floats shift) {
        return hn::MulSub(hn::Load(lanes, planes + plane + i), inverse, shift);
      };
      const Floats entry = hn::Max(hn::Max(at(x, inverse_x, near_x), at(y, inverse_y, near_y)),
                                   hn::Max(at(z, inverse_z, near_z), hn::Zero(lanes)));
      const Floats exit = hn::Min(hn::Min(at(x ^ other, inverse_x, far_x), at(y ^ other, inverse_y, far_y)),
                                  hn::Min(at(z ^ other, inverse_z, far_z), hn::Set(lanes, limit)));
      hn::Store(entry, lanes, entries + i);
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(lanes, hn::Le(entry, exit), bits);
      reached |= static_cast<std::uint32_t>(bits[0]) << i;
    }
    return reached;
  }
};

/// What a block of triangles may have for a probe.
struct Possible {
  std::uint32_t maybe = 0, certain = 0;                 // bits; certain ones are in maybe too
  alignas(32) float nearest[width], farthest[width];  // bounds on the distance of the certain; nearest also of others
};

/// Which triangles of a block are not certainly missed before `limit`.
///   source  the edge functions of Moller, Trumbore, Fast, minimum storage ray/triangle intersection (1997), undivided
HWY_INLINE void TestTriangles(const TriangleBlock& block, const Probe& probe, float limit, Possible& possible) {
  const Lanes lanes;
  possible.maybe = possible.certain = 0;
  for (std::size_t i = 0; i < width; i += hn::Lanes(lanes)) {
    const auto set = [&](float x) { return hn::Set(lanes, x); };
    const auto load = [&](const float* from) { return hn::Load(lanes, from + i); };
    const Floats dx = set(probe.direction[0]), dy = set(probe.direction[1]), dz = set(probe.direction[2]);
    const Floats cx = hn::Sub(load(block.corner[0]), set(probe.origin[0]));
    const Floats cy = hn::Sub(load(block.corner[1]), set(probe.origin[1]));
    const Floats cz = hn::Sub(load(block.corner[2]), set(probe.origin[2]));
    const Floats ax = load(block.edge1[0]), ay = load(block.edge1[1]), az = load(block.edge1[2]);
    const Floats bx = load(block.edge2[0]), by = load(block.edge2[1]), bz = load(block.edge2[2]);
    const auto minus = [](Floats p, Floats q, Floats r, Floats s) { return hn::MulSub(p, q, hn::Mul(r, s)); };
    const auto dot = [](Floats px, Floats py, Floats pz, Floats qx, Floats qy, Floats qz) {
      return hn::MulAdd(px, qx, hn::MulAdd(py, qy, hn::Mul(pz, qz)));
    };
    const Floats rx = minus(cy, dz, cz, dy), ry = minus(cz, dx, cx, dz), rz = minus(cx, dy, cy, dx);
    const Floats nx = minus(ay, bz, az, by), ny = minus(az, bx, ax, bz), nz = minus(ax, by, ay, bx);
    const Floats facing = dot(nx, ny, nz, dx, dy, dz);
    const Floats v = dot(rx, ry, rz, bx, by, bz);
    const Floats w = hn::Neg(dot(rx, ry, rz, ax, ay, az));
    const Floats rest = hn::Sub(hn::Sub(facing, v), w);
    const auto sum = [](Floats x, Floats y, Floats z) { return hn::Add(hn::Abs(x), hn::Add(hn::Abs(y), hn::Abs(z))); };
    const Floats a = sum(ax, ay, az), b = sum(bx, by, bz), area = hn::Mul(a, b);
    // The last term is for products below the range of floats.
    const Floats slack_of_facing = hn::MulAdd(area, set(32 * u), set(1e-30f));
    const Floats slack = hn::MulAdd(hn::Add(a, b), set(probe.slack_of_edges), slack_of_facing);
    const Floats least = hn::Min(v, hn::Min(w, rest)), most = hn::Max(v, hn::Max(w, rest));
    auto maybe = hn::Or(hn::Ge(least, hn::Neg(slack)), hn::Le(most, slack));
    if (hn::AllFalse(lanes, maybe)) continue;

    // Edge-on, nothing is known of distances.
    const Floats height = dot(nx, ny, nz, cx, cy, cz), steep = hn::Abs(facing);
    const Floats ahead = hn::Xor(height, hn::And(facing, hn::SignBit(lanes)));
    const Floats slack_of_height = hn::MulAdd(area, set(probe.slack_of_height), set(1e-30f));
    const auto is_clear = hn::Gt(steep, hn::Add(slack_of_facing, slack_of_facing));
    const Floats low = hn::Sub(ahead, slack_of_height), high = hn::Add(ahead, slack_of_height);
    const Floats wide = hn::Add(steep, slack_of_facing), narrow = hn::Sub(steep, slack_of_facing);
    // Dividing may round by u; so may what follows.
    const Floats nearest = hn::Mul(hn::Div(low, hn::IfThenElse(hn::Ge(low, hn::Zero(lanes)), wide, narrow)),
                                   set(1 - 4 * u));
    const Floats farthest = hn::Mul(hn::Div(high, narrow), set(1 + 4 * u));
    const auto is_far = hn::Gt(nearest, set(limit)), is_behind = hn::Lt(high, hn::Zero(lanes));
    maybe = hn::AndNot(hn::And(is_clear, hn::Or(is_far, is_behind)), maybe);
    if (hn::AllFalse(lanes, maybe)) continue;
    const auto is_inside = hn::Or(hn::Gt(least, slack), hn::Lt(most, hn::Neg(slack)));
    const auto is_in_front = hn::Gt(nearest, set(probe.slack));
    const auto certain = hn::And(maybe, hn::And(is_clear, hn::And(is_inside, is_in_front)));
    hn::Store(hn::IfThenElseZero(is_clear, nearest), lanes, possible.nearest + i);
    hn::Store(farthest, lanes, possible.farthest + i);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(lanes, maybe, bits);
    possible.maybe |= static_cast<std::uint32_t>(bits[0]) << i;
    hn::StoreMaskBits(lanes, certain, bits);
    possible.certain |= static_cast<std::uint32_t>(bits[0]) << i;
  }
}

/// Children that wait, the nearest on top: distance in the high half, so that whole numbers order them.
HWY_INLINE std::uint64_t Wait(float entry, std::uint32_t child) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(entry)} << 32 | child;
}
HWY_INLINE float EntryOf(std::uint64_t waiting) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(waiting >> 32));
}
HWY_INLINE void Order(std::uint64_t& farther, std::uint64_t& nearer) {
  const std::uint64_t a = farther, b = nearer;
  farther = std::max(a, b), nearer = std::min(a, b);
}

/// One walk through the trees.
template <bool any>
class Walk {
 public:
  Walk(const Forest& forest, NearestHit& nearest, Counts& counts) : forest_(forest), nearest_(nearest), counts_(counts) {}

  /// Through one tree; `instance` is the shared mesh's whose inside it is. True when `any` is answered.
  bool Through(const Tree& tree, const R3::Ray& ray, double distance_in_world, std::optional<std::uint32_t> instance) {
    const Probe probe(tree, ray, distance_in_world);
    if (probe.is_lost) return false;
    const BoxProbe boxes(probe);
    std::uint64_t stack[most_depth * width];
    std::uint64_t* top = stack;  // one past the last that waits
    std::uint32_t child = tree.root;
    Candidates candidates(*this, tree, ray, probe, instance);
    float limit = probe.Distance(nearest_.Limit());
    const float limit_for_certain = limit - 4 * probe.slack;
    std::uint64_t nodes = 0, leaves = 0;
    bool is_answered = false;

    while (true) {
      const auto kind = Child::KindOf(child);
      if (HWY_LIKELY(kind == Child::Kind::node)) {
        ++nodes;
        const Node& node = tree.At<Node>(child);
        alignas(32) float entries[width];
        std::uint32_t reached = boxes.Test(node, limit, entries);
        if (HWY_LIKELY(reached != 0)) {
          if ((reached & (reached - 1)) == 0) {
            child = node.child[std::countr_zero(reached)];
            continue;
          }
          if constexpr (any) {  // whichever comes first
            do {
              const int i = std::countr_zero(reached);
              if (tree.is_large) Fetch(tree, node.child[i]);
              *top++ = Wait(entries[i], node.child[i]);
              reached &= reached - 1;
            } while (reached != 0);
            child = static_cast<std::uint32_t>(*--top);
            continue;
          }
          const auto take = [&] {
            const int i = std::countr_zero(reached);
            reached &= reached - 1;
            return Wait(entries[i], node.child[i]);
          };
          std::uint64_t first = take(), second = take();
          if (tree.is_large) {
            Fetch(tree, static_cast<std::uint32_t>(first));
            Fetch(tree, static_cast<std::uint32_t>(second));
          }
          Order(second, first);
          if (reached != 0) {
            std::uint64_t third = take();
            if (tree.is_large) Fetch(tree, static_cast<std::uint32_t>(third));
            Order(third, first), Order(third, second);
            std::uint64_t* const base = top;
            *top++ = third, *top++ = second;
            while (reached != 0) {
              std::uint64_t next = take();
              if (tree.is_large) Fetch(tree, static_cast<std::uint32_t>(next));
              Order(next, first);
              std::uint64_t* at = top++;
              while (at > base && at[-1] < next) *at = at[-1], --at;
              *at = next;
            }
          } else {
            *top++ = second;
          }
          child = static_cast<std::uint32_t>(first);
          continue;
        }
      } else if (kind == Child::Kind::triangles) {
        ++leaves;
        const TriangleBlock& block = tree.At<TriangleBlock>(child);
        Possible possible;
        TestTriangles(block, probe, limit, possible);
        for (std::uint32_t rest = possible.maybe; rest; rest &= rest - 1) {
          const int i = std::countr_zero(rest);
          const bool is_certain = possible.certain >> i & 1;
          if constexpr (any) {
            is_answered = (is_certain && possible.farthest[i] < limit_for_certain) || candidates.Ask(block.item[i]);
            if (is_answered) goto done;
          } else {
            candidates.Add(block.item[i], possible.nearest[i], is_certain ? possible.farthest[i] : none, limit);
          }
        }
      } else if (kind == Child::Kind::item) {
        ++leaves;
        candidates.Resolve(limit);
        is_answered = AskItem(tree, Child::Index(child), ray, distance_in_world) && any;
        if (is_answered) goto done;
        limit = std::min(limit, probe.Distance(nearest_.Limit()));
      }
      do {
        if (top == stack) goto done;
        --top;
      } while (EntryOf(*top) > limit);
      child = static_cast<std::uint32_t>(*top);
    }
  done:
    candidates.Resolve(limit);
    counts_.node_visits += nodes + leaves;
    counts_.box_tests += nodes * width;
    return is_answered;
  }

 private:
  static constexpr float none = std::numeric_limits<float>::infinity();

  /// Triangles that doubles may have to decide about. Where their corners are in memory is looked up in steps while the
  /// walk goes on, so that deciding need not wait for it.
  class Candidates {
   public:
    HWY_INLINE Candidates(Walk& walk, const Tree& tree, const R3::Ray& ray, const Probe& probe,
                          std::optional<std::uint32_t> instance)
        : walk_(walk), tree_(tree), probe_(probe), instance_(instance), sheared_(ray) {}

    HWY_INLINE void Add(std::uint32_t item, float nearest, float farthest, float& limit) {
      if (count_ == most) Resolve(limit);
      list_[count_] = {nearest, Find(item)};
      __builtin_prefetch(&list_[count_].place.Indices());
      ++count_;
      limit = std::min(limit, farthest);
    }

    /// Asks those that may still be the nearest, last found first.
    HWY_INLINE void Resolve(float& limit) {
      for (int i = 0; i < count_; ++i)
        for (const std::uint32_t corner : list_[i].place.Indices())
          __builtin_prefetch(&list_[i].place.mesh->Data().positions[corner]);
      while (count_ > 0) {
        --count_;
        if (list_[count_].nearest <= limit && Ask(list_[count_].place))
          limit = std::min(limit, probe_.Distance(walk_.nearest_.Limit()));
      }
    }

    HWY_INLINE bool Ask(std::uint32_t item) { return Ask(Find(item)); }

   private:
    struct Place {
      const R3::Mesh* mesh;
      std::uint32_t instance;
      std::int32_t element;

      const std::array<std::uint32_t, 3>& Indices() const {
        return mesh->Data().triangles[static_cast<std::size_t>(element)];
      }
    };
    struct Candidate {
      float nearest;
      Place place;
    };
    static constexpr int most = 16;

    HWY_INLINE Place Find(std::uint32_t item) const {
      const Item what = tree_.space[item];
      const std::uint32_t of = instance_.value_or(what.instance);
      return {walk_.forest_.world->Instances()[of].mesh, of, what.element};
    }

    HWY_FLATTEN bool Ask(const Place& place) {
      NearestHit& best = walk_.nearest_;
      if (best.Best()) sheared_.t_max = std::min(sheared_.t_max, R3::NextUp(best.Limit()));
      ++walk_.counts_.primitive_tests;
      const auto hit = R3::IntersectTriangleInline(sheared_, place.mesh->Corners(place.element));
      if (!hit) return false;
      best.Offer({*hit, place.instance, place.element});
      return true;
    }

    Walk& walk_;
    const Tree& tree_;
    const Probe& probe_;
    std::optional<std::uint32_t> instance_;
    R3::ShearedRay sheared_;
    int count_ = 0;
    std::array<Candidate, most> list_;
  };

  HWY_INLINE static void Fetch(const Tree& tree, std::uint32_t child) {
    // Of an item this is some other place in memory or none: harmless.
    const char* at = reinterpret_cast<const char*>(tree.memory.Data() + Child::Index(child));
    for (int line = 0; line < 4; ++line) __builtin_prefetch(at + 64 * line);
  }

  bool AskItem(const Tree& tree, std::uint32_t item, const R3::Ray& ray, double distance_in_world) {
    const Item what = tree.space[item];
    const Instance& instance = forest_.world->Instances()[what.instance];
    const R3::Transform& frame = forest_.world->Frames()[instance.frame];
    const R3::Ray local = instance.frame == 0 ? ray : frame.Back(ray);
    if (what.element == Item::whole)
      return Through(forest_.trees[static_cast<std::size_t>(instance.shared) + 1], local, distance_in_world,
                     what.instance);
    nearest_.Test(what.instance, what.element, local, counts_);
    return nearest_.Best().has_value();
  }

  const Forest& forest_;
  NearestHit& nearest_;
  Counts& counts_;
};

void Nearest(const Forest& forest, const R3::Ray& ray, NearestHit& nearest, Counts& counts) {
  Walk<false>(forest, nearest, counts)
      .Through(forest.trees[0], ray, MaxComponent(Abs(FromOrigin(ray.origin))), std::nullopt);
}

bool Any(const Forest& forest, const R3::Ray& ray, Counts& counts) {
  NearestHit nearest(*forest.world, ray);
  return Walk<true>(forest, nearest, counts)
      .Through(forest.trees[0], ray, MaxComponent(Abs(FromOrigin(ray.origin))), std::nullopt);
}

Kernels Compiled() { return {hwy::TargetName(HWY_TARGET), &Nearest, &Any}; }

}  // namespace HWY_NAMESPACE
}  // namespace ray::bvh
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ray::bvh {
namespace {

HWY_EXPORT(Compiled);

/// One entry for each instruction set of this machine, the best first.
const std::vector<Kernels>& AllKernels() {
  static const std::vector<Kernels> all = [] {
    std::vector<Kernels> list;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      hwy::GetChosenTarget().Update(hwy::SupportedTargets());
      list.push_back(HWY_DYNAMIC_DISPATCH(Compiled)());
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return list;
  }();
  return all;
}

}  // namespace

std::vector<std::string> InstructionSets() {
  std::vector<std::string> names;
  for (const Kernels& kernels : AllKernels()) names.emplace_back(kernels.name);
  return names;
}

const Kernels& ChooseKernels(const std::string& instruction_set) {
  for (const Kernels& kernels : AllKernels())
    if (instruction_set == "best" || instruction_set == kernels.name) return kernels;
  throw std::invalid_argument("this machine has no instruction set " + instruction_set);
}

std::size_t Forest::Bytes() const {
  std::size_t sum = 0;
  for (const Tree& tree : trees) sum += tree.Bytes();
  return sum;
}

}  // namespace ray::bvh
#endif
