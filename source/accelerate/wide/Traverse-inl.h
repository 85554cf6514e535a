// One ray through a wide tree of boxes. Included once per instruction set.

#if defined(RAY_ACCELERATE_WIDE_TRAVERSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_TRAVERSE_INL_H_
#undef RAY_ACCELERATE_WIDE_TRAVERSE_INL_H_
#else
#define RAY_ACCELERATE_WIDE_TRAVERSE_INL_H_
#endif

#include <type_traits>

#include "source/accelerate/wide/Search-inl.h"
#include "source/accelerate/wide/Tree.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

using wide::Child;
using wide::Node;
using wide::Tree;

/// A traversal ray prepared for the slab test of eight boxes, kept in registers during traversal.
struct NodeRay {
  Vec3<Lanes> inverse, near, far;
  std::int64_t x, y, z;  // the near planes in Node::plane, in floats

  template <typename RayInBoxes>
  HWY_INLINE explicit NodeRay(const RayInBoxes& p)
      : inverse(Broadcast(Lanes(), p.inverse)),
        near(Broadcast(Lanes(), p.near_shift)),
        far(Broadcast(Lanes(), p.far_shift)),
        x(p.DownwardMask(0) & width),
        y((p.DownwardMask(1) & width) + 2 * width),
        z((p.DownwardMask(2) & width) + 4 * width) {}

  /// Returns the children of a node that are entered before `limit`, as bits, and their entries.
  HWY_INLINE std::uint32_t Test(const Node& node, float limit, float* HWY_RESTRICT entries) const {
    const Lanes lanes;
    const float* planes = node.planes;
    constexpr std::int64_t other = width;  // low and high planes alternate: the far one is adjacent
    std::uint32_t reached = 0;
    for (std::size_t i = 0; i < width; i += hn::Lanes(lanes)) {
      const auto at = [&](std::int64_t plane, Floats slope, Floats shift) {
        return hn::MulSub(hn::Load(lanes, planes + i + plane), slope, shift);
      };
      const Floats entry = hn::Max(hn::Max(at(x, inverse.x, near.x), at(y, inverse.y, near.y)),
                                   hn::Max(at(z, inverse.z, near.z), hn::Zero(lanes)));
      const Floats exit = hn::Min(hn::Min(at(x ^ other, inverse.x, far.x), at(y ^ other, inverse.y, far.y)),
                                  hn::Min(at(z ^ other, inverse.z, far.z), hn::Set(lanes, limit)));
      hn::Store(entry, lanes, entries + i);
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(lanes, hn::Le(entry, exit), bits);
      reached |= static_cast<std::uint32_t>(bits[0]) << i;
    }
    return reached;
  }
};

/// Packs an entry of the traversal stack: the distance at which a child is entered in the high half, so that comparing
/// integers orders entries, and the child.
HWY_INLINE std::uint64_t PackEntry(float distance, std::uint32_t child) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(distance)} << 32 | child;
}
HWY_INLINE float DistanceOf(std::uint64_t entry) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(entry >> 32));
}
/// Orders two entries without a branch, since their order is unpredictable.
HWY_INLINE void Order(std::uint64_t& farther, std::uint64_t& nearer) {
  const std::uint64_t swap = -static_cast<std::uint64_t>(farther < nearer) & (farther ^ nearer);
  farther ^= swap, nearer ^= swap;
}

using Wholes = hn::CappedTag<std::int32_t, width>;

/// Returns the distances of the children reached, as integers in the same order, with the lane in the lowest bits,
/// which orders equal ones. Other children have -1.
template <typename D>
HWY_INLINE hn::Vec<D> SortKeys(D d, const float* HWY_RESTRICT distances, std::uint32_t reached, std::size_t first) {
  const auto lane = hn::Iota(d, static_cast<std::int32_t>(first));
  const auto is_reached = hn::TestBit(hn::Set(d, static_cast<std::int32_t>(reached)), hn::Shl(hn::Set(d, 1), lane));
  const auto distance = hn::BitCast(d, hn::Load(Lanes(), distances + first));
  return hn::IfThenElse(is_reached, hn::Or(hn::AndNot(hn::Set(d, width - 1), distance), lane), hn::Set(d, -1));
}

HWY_INLINE void Prefetch(const Tree& tree, std::uint32_t child) {
  // For a primitive this is some other or an invalid address, which does no harm.
  const char* at = reinterpret_cast<const char*>(tree.memory.Data() + Child::Index(child));
  for (int line = 0; line < 4; ++line) __builtin_prefetch(at + 64 * line);
}
HWY_INLINE void PrefetchEach(const Tree& tree, const Node& node, std::uint32_t reached) {
  for (; reached != 0; reached &= reached - 1) Prefetch(tree, node.child[std::countr_zero(reached)]);
}

/// The next child to visit, and the new top of the stack.
template <typename Entry>
struct Pushed {
  std::uint32_t next;
  Entry* top;
};

/// Pushes two or more reached children in any order, for occlusion rays. Once reached, a child stays relevant to the
/// end, so the stack needs no distances.
HWY_INLINE Pushed<std::uint32_t> PushUnsorted(const Tree& tree, const Node& node, std::uint32_t reached,
                                              std::uint32_t* top) {
  if (tree.is_large) PrefetchEach(tree, node, reached);
  const int last = std::bit_width(reached) - 1;
  for (reached ^= std::uint32_t{1} << last; reached != 0; reached &= reached - 1)
    *top++ = node.child[std::countr_zero(reached)];
  return {node.child[last], top};
}

/// Pushes three or more reached children for nearest hits, farthest first. May write `width` entries from `top` on.
#if HWY_TARGET != HWY_SCALAR && HWY_MAX_BYTES >= 32
/// Sorts eight numbers, the largest first, by a network of six rounds that compare pairs of lanes.
///   source  Batcher, Sorting networks and their applications (1968)
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE V SortDescending(D d, V keys) {
  const hn::Repartition<std::int64_t, D> pairs;
  const auto compare = [&](V other, auto blend) HWY_ATTR { keys = blend(hn::Max(keys, other), hn::Min(keys, other)); };
  const auto by_lane = [](V first, V second) HWY_ATTR { return hn::OddEven(second, first); };
  const auto by_pair = [&](V first, V second) HWY_ATTR {
    return hn::BitCast(d, hn::OddEven(hn::BitCast(pairs, second), hn::BitCast(pairs, first)));
  };
  const auto by_half = [&](V first, V second) HWY_ATTR { return hn::ConcatUpperLower(d, second, first); };
  compare(hn::Shuffle2301(keys), by_lane);
  compare(hn::Shuffle0123(keys), by_pair);
  compare(hn::Shuffle2301(keys), by_lane);
  compare(hn::Reverse(d, keys), by_half);
  compare(hn::Shuffle1032(keys), by_pair);
  compare(hn::Shuffle2301(keys), by_lane);
  return keys;
}

HWY_INLINE Pushed<std::uint64_t> PushMany(const Node& node, const float* HWY_RESTRICT distances, std::uint32_t reached,
                                          std::uint64_t* top) {
  const Wholes d;
  const hn::RebindToUnsigned<Wholes> u;
  const auto keys = SortKeys(d, distances, reached, 0);
  // Found separately from the others, so that traversal need not wait for their order.
  const std::uint32_t first = hn::GetLane(hn::MinOfLanes(u, hn::BitCast(u, keys))) & (width - 1);
  const auto lanes = hn::IndicesFromVec(d, hn::And(SortDescending(d, keys), hn::Set(d, width - 1)));
  const auto children = hn::TableLookupLanes(hn::BitCast(d, hn::Load(u, node.child)), lanes);
  const auto entries = hn::TableLookupLanes(hn::BitCast(d, hn::Load(Lanes(), distances)), lanes);
  const auto even = hn::InterleaveLower(d, children, entries), odd = hn::InterleaveUpper(d, children, entries);
  auto* const to = reinterpret_cast<std::int32_t*>(top);
  hn::StoreU(hn::ConcatLowerLower(d, odd, even), d, to);
  hn::StoreU(hn::ConcatUpperUpper(d, odd, even), d, to + width);
  return {node.child[first], top + std::popcount(reached) - 1};
}
#else
HWY_INLINE Pushed<std::uint64_t> PushMany(const Node& node, const float* HWY_RESTRICT distances, std::uint32_t reached,
                                          std::uint64_t* top) {
  const Wholes d;
  alignas(32) std::int32_t keys[width];
  for (std::size_t k = 0; k < width; k += hn::Lanes(d)) hn::Store(SortKeys(d, distances, reached, k), d, keys + k);
  for (std::uint32_t rest = reached; rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    std::uint32_t farther = 0;
    for (std::size_t k = 0; k < width; k += hn::Lanes(d)) {
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, hn::Gt(hn::Load(d, keys + k), hn::Set(d, keys[i])), bits);
      farther |= static_cast<std::uint32_t>(bits[0]) << k;
    }
    top[std::popcount(farther)] = PackEntry(distances[i], node.child[i]);
  }
  top += std::popcount(reached) - 1;
  return {static_cast<std::uint32_t>(*top), top};
}
#endif

/// Pushes two or more reached children for nearest hits, the nearest on top.
HWY_INLINE Pushed<std::uint64_t> PushSorted(const Tree& tree, const Node& node, const float* HWY_RESTRICT distances,
                                            std::uint32_t reached, std::uint64_t* top) {
  if (tree.is_large) PrefetchEach(tree, node, reached);
  const int i = std::countr_zero(reached), k = std::bit_width(reached) - 1;
  if (reached != (std::uint32_t{1} << i | std::uint32_t{1} << k)) return PushMany(node, distances, reached, top);
  std::uint64_t first = PackEntry(distances[i], node.child[i]), second = PackEntry(distances[k], node.child[k]);
  Order(second, first);
  *top++ = second;
  return {static_cast<std::uint32_t>(first), top};
}

/// Visits a leaf that does not contain triangles; returns true if that ends the search. Out of line, so that the
/// traversal of triangles keeps its registers.
template <typename LeafVisitor>
HWY_NOINLINE bool VisitOthers(const Tree& tree, std::uint32_t child, LeafVisitor& visitor) {
  if (Child::KindOf(child) == Child::Kind::sphere) return visitor.VisitSphere(tree.At<SphereLeaf>(child));
  if (Child::KindOf(child) == Child::Kind::hulls) return visitor.VisitHulls(tree.At<HullBlock>(child));
  return visitor.VisitPrimitive(Child::Index(child));
}

/// Traverses from a child of any kind, with a stack of the children still to be visited, nearest on top.
template <bool any, typename LeafVisitor>
HWY_INLINE void TraverseFrom(std::uint32_t child, const Tree& tree, const NodeRay& ray, LeafVisitor& visitor,
                             Counts& counts) {
  using Entry = std::conditional_t<any, std::uint32_t, std::uint64_t>;
  Entry stack[(wide::most_depth + 1) * width];
  Entry* top = stack;  // one past the last entry
  std::uint64_t nodes = 0, leaves = 0;

  while (true) {
    const auto kind = Child::KindOf(child);
    if (HWY_LIKELY(kind == Child::Kind::node)) {
      ++nodes;
      const Node& node = tree.At<Node>(child);
      alignas(32) float distances[width];
      const std::uint32_t reached = ray.Test(node, visitor.limit, distances);
      if (HWY_LIKELY(reached != 0)) {
        if ((reached & (reached - 1)) == 0) {
          child = node.child[std::countr_zero(reached)];
          continue;
        }
        Pushed<Entry> pushed;
        if constexpr (any)
          pushed = PushUnsorted(tree, node, reached, top);
        else
          pushed = PushSorted(tree, node, distances, reached, top);
        child = pushed.next, top = pushed.top;
        continue;
      }
    } else if (kind == Child::Kind::triangles) {
      ++leaves;
      if (visitor.VisitTriangles(tree.At<TriangleBlock>(child))) break;
    } else if (!Child::IsNothing(child)) {
      ++leaves;
      if (VisitOthers(tree, child, visitor)) break;
    }
    do {
      if (top == stack) goto done;
      --top;
    } while (!any && DistanceOf(*top) > visitor.limit);
    child = static_cast<std::uint32_t>(*top);
  }
done:
  counts.node_visits += nodes + leaves;
  counts.box_tests += nodes * width;
}

template <bool any, typename LeafVisitor>
HWY_INLINE void Traverse(const Tree& tree, const TraversalRay& ray, LeafVisitor& visitor, Counts& counts) {
  TraverseFrom<any>(tree.root, tree, NodeRay(ray), visitor, counts);
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
