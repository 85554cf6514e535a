#include "source/accelerate/wide/Layout.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <vector>

namespace ray::bvh {
namespace {

constexpr std::uint32_t units_of_node = sizeof(Node) / unit, units_of_block = sizeof(TriangleBlock) / unit;
constexpr std::uint32_t most_units = (std::uint32_t{1} << Child::kind_shift) - 64;
constexpr std::size_t own_cache = std::size_t{1} << 22;  // of a core, about

struct Placed {
  const BuildNode* draft;
  std::uint32_t at;
  std::array<std::uint32_t, width> child;
};
struct Block {
  const BuildChild* slot;
  std::uint32_t at;
};

/// Gives everything its place, one slot and what is below it after the other.
class Placing {
 public:
  explicit Placing(Tree& tree) : tree_(tree) {}

  std::uint32_t Place(const BuildChild& slot) {
    if (slot.IsEmpty()) return Child::Make(Child::Kind::nothing, 0);
    if (!slot.below) return PlaceLeaf(slot);
    const std::uint32_t top = Child::Make(Child::Kind::node, end);
    std::vector<Waiting> stack{{slot.below, 0, 0, 1}};
    const std::size_t first = nodes.size();
    while (!stack.empty()) {
      const Waiting next = stack.back();
      stack.pop_back();
      tree_.depth = std::max(tree_.depth, next.depth);
      if (nodes.size() > first) nodes[next.parent].child[next.slot] = Child::Make(Child::Kind::node, end);
      const std::size_t self = nodes.size();
      nodes.push_back({next.draft, end, {}});
      end += units_of_node;
      const auto children = static_cast<std::size_t>(next.draft->children);
      for (std::size_t i = 0; i < children; ++i)
        if (!next.draft->slots[i].below) nodes[self].child[i] = PlaceLeaf(next.draft->slots[i]);
      if (end > most_units) throw std::length_error("the scene is too large: its tree would take more than 32 GB");
      for (std::size_t i = children; i-- > 0;)
        if (const BuildNode* below = next.draft->slots[i].below) stack.push_back({below, self, i, next.depth + 1});
    }
    return top;
  }

  std::vector<Placed> nodes;
  std::vector<Block> blocks;
  std::uint32_t end = 0;

 private:
  struct Waiting {
    const BuildNode* draft;
    std::size_t parent, slot;
    int depth;
  };

  std::uint32_t PlaceLeaf(const BuildChild& slot) {
    if (slot.triangles == 0) return Child::Make(Child::Kind::item, slot.items[0]);
    const std::uint32_t self = Child::Make(Child::Kind::triangles, end);
    blocks.push_back({&slot, end});
    end += units_of_block;
    return self;
  }

  Tree& tree_;
};

void Fill(const Placed& placed, Tree& tree) {
  Node& node = *new (&tree.memory[placed.at]) Node;
  for (int i = 0; i < width; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool is_there = i < placed.draft->children;
    const BuildChild& slot = placed.draft->slots[k];
    constexpr float nowhere = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
      node.plane[2 * axis][i] = is_there ? static_cast<float>(slot.box.low[axis]) : nowhere;
      node.plane[2 * axis + 1][i] = is_there ? static_cast<float>(slot.box.high[axis]) : -nowhere;
    }
    node.child[i] = is_there ? placed.child[k] : Child::Make(Child::Kind::nothing, 0);
  }
}

template <typename Body>
void ForAll(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 64), [&](const auto& r) {
    for (std::size_t i = r.begin(); i != r.end(); ++i) body(i);
  });
}

}  // namespace

std::vector<std::uint32_t> Flatten(std::span<const BuildChild> slots, Tree& tree) {
  Placing placing(tree);
  std::vector<std::uint32_t> children;
  children.reserve(slots.size());
  for (const BuildChild& slot : slots) children.push_back(placing.Place(slot));
  tree.memory = HugeArray<Tree::Unit>(placing.end);
  tree.nodes = placing.nodes.size(), tree.blocks = placing.blocks.size();
  ForAll(placing.nodes.size(), [&](std::size_t i) { Fill(placing.nodes[i], tree); });
  ForAll(placing.blocks.size(), [&](std::size_t i) {
    const auto& [slot, at] = placing.blocks[i];
    FillBlock(*new (&tree.memory[at]) TriangleBlock, tree.space, tree.coordinates, slot->items.data(), slot->triangles);
  });
  tree.is_large = tree.Bytes() > own_cache;
  return children;
}

}  // namespace ray::bvh
