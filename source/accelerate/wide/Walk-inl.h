// One ray through a tree of boxes: included once for each instruction set.

#if defined(RAY_ACCELERATE_BVH_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_BVH_WALK_INL_H_
#undef RAY_ACCELERATE_BVH_WALK_INL_H_
#else
#define RAY_ACCELERATE_BVH_WALK_INL_H_
#endif

#include "source/accelerate/wide/Search-inl.h"
#include "source/accelerate/wide/Tree.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

using bvh::Child;
using bvh::Node;
using bvh::Tree;

/// A probe ready for nodes: in registers while it walks.
struct BoxProbe {
  Floats inverse_x, inverse_y, inverse_z, near_x, near_y, near_z, far_x, far_y, far_z;
  std::uint32_t x, y, z;  // the near planes in Node::plane, in floats

  HWY_INLINE explicit BoxProbe(const TraversalRay& p)
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

/// Children that wait, the nearest on top: distance in the high half, so that whole numbers order them.
HWY_INLINE std::uint64_t Wait(float entry, std::uint32_t child) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(entry)} << 32 | child;
}
HWY_INLINE float EntryOf(std::uint64_t waiting) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(waiting >> 32));
}
/// Without a branch: which of two is nearer is anyone's guess.
HWY_INLINE void Order(std::uint64_t& farther, std::uint64_t& nearer) {
  const std::uint64_t swap = -static_cast<std::uint64_t>(farther < nearer) & (farther ^ nearer);
  farther ^= swap, nearer ^= swap;
}

/// Distances of the children reached, for ranking them; equal ones by their lane.
struct Keys {
  using Wholes = hn::CappedTag<std::int32_t, width>;
  alignas(32) std::int32_t lanes[width];

  HWY_INLINE int CountFarther(int i) const {
    const Wholes d;
    std::uint32_t farther = 0;
    for (std::size_t k = 0; k < width; k += hn::Lanes(d)) {
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, hn::Gt(hn::Load(d, lanes + k), hn::Set(d, lanes[i])), bits);
      farther |= static_cast<std::uint32_t>(bits[0]) << k;
    }
    return std::popcount(farther);
  }
};

HWY_INLINE Keys KeysOf(const float* HWY_RESTRICT entries, std::uint32_t reached) {
  const Keys::Wholes d;
  Keys keys;
  for (std::size_t k = 0; k < width; k += hn::Lanes(d)) {
    const auto bit = hn::Shl(hn::Set(d, 1), hn::Iota(d, static_cast<std::int32_t>(k)));
    const auto is_reached = hn::TestBit(hn::Set(d, static_cast<std::int32_t>(reached)), bit);
    const auto entry = hn::BitCast(d, hn::Load(Lanes(), entries + k));
    const auto key = hn::Or(hn::AndNot(hn::Set(d, width - 1), entry), hn::Iota(d, static_cast<std::int32_t>(k)));
    hn::Store(hn::IfThenElse(is_reached, key, hn::Set(d, -1)), d, keys.lanes + k);
  }
  return keys;
}

HWY_INLINE void Fetch(const Tree& tree, std::uint32_t child) {
  // Of an item this is some other place in memory or none: harmless.
  const char* at = reinterpret_cast<const char*>(tree.memory.Data() + Child::Index(child));
  for (int line = 0; line < 4; ++line) __builtin_prefetch(at + 64 * line);
}

template <bool any, typename LeafVisitor>
HWY_INLINE void WalkFrom(std::uint32_t child, const Tree& tree, const BoxProbe& boxes, LeafVisitor& asker,
                         Counts& counts) {
  std::uint64_t stack[bvh::most_depth * width];
  std::uint64_t* top = stack;  // one past the last that waits
  std::uint64_t nodes = 0, leaves = 0;

  while (true) {
    const auto kind = Child::KindOf(child);
    if (HWY_LIKELY(kind == Child::Kind::node)) {
      ++nodes;
      const Node& node = tree.At<Node>(child);
      alignas(32) float entries[width];
      std::uint32_t reached = boxes.Test(node, asker.limit, entries);
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
        const std::uint32_t whole = reached;
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
          const Keys all = KeysOf(entries, whole);
          std::uint64_t* const base = top;
          top += std::popcount(whole);
          for (std::uint32_t rest = whole; rest != 0; rest &= rest - 1) {
            const int i = std::countr_zero(rest);
            if (tree.is_large) Fetch(tree, node.child[i]);
            base[all.CountFarther(i)] = Wait(entries[i], node.child[i]);
          }
          first = *--top;
        } else {
          *top++ = second;
        }
        child = static_cast<std::uint32_t>(first);
        continue;
      }
    } else if (kind == Child::Kind::triangles) {
      ++leaves;
      if (asker.AskBlock(tree.At<TriangleBlock>(child))) break;
    } else if (kind == Child::Kind::item) {
      ++leaves;
      if (asker.AskItem(Child::Index(child))) break;
    }
    do {
      if (top == stack) goto done;
      --top;
    } while (EntryOf(*top) > asker.limit);
    child = static_cast<std::uint32_t>(*top);
  }
done:
  counts.node_visits += nodes + leaves;
  counts.box_tests += nodes * width;
}

template <bool any, typename LeafVisitor>
HWY_INLINE void Walk(const Tree& tree, const TraversalRay& probe, LeafVisitor& asker, Counts& counts) {
  WalkFrom<any>(tree.root, tree, BoxProbe(probe), asker, counts);
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
