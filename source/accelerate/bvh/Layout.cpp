#include "source/accelerate/bvh/Layout.h"

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
  const Draft* draft;
  std::uint32_t at;
  std::array<std::uint32_t, width> child;
};

std::vector<Placed> Place(const Draft& root, Tree& tree, std::uint32_t& end) {
  struct Waiting {
    const Draft* draft;
    std::size_t parent, slot;
    int depth;
  };
  std::vector<Placed> placed;
  std::vector<Waiting> stack{{&root, 0, 0, 1}};
  while (!stack.empty()) {
    const Waiting next = stack.back();
    stack.pop_back();
    tree.depth = std::max(tree.depth, next.depth);
    const std::uint32_t self = Child::Make(Child::Kind::node, end);
    (placed.empty() ? tree.root : placed[next.parent].child[next.slot]) = self;
    Placed& node = placed.emplace_back(Placed{next.draft, end, {}});
    ++tree.nodes;
    end += units_of_node;
    const auto children = static_cast<std::size_t>(next.draft->children);
    for (std::size_t i = 0; i < children; ++i) {
      const Slot& slot = next.draft->slots[i];
      if (slot.below) continue;  // set when its turn comes
      if (slot.triangles == 0) {
        node.child[i] = Child::Make(Child::Kind::item, slot.items[0]);
        continue;
      }
      node.child[i] = Child::Make(Child::Kind::triangles, end);
      ++tree.blocks;
      end += units_of_block;
    }
    if (end > most_units) throw std::length_error("the scene is too large: its tree would take more than 32 GB");
    for (std::size_t i = children; i-- > 0;)
      if (const Draft* below = next.draft->slots[i].below)
        stack.push_back({below, placed.size() - 1, i, next.depth + 1});
  }
  return placed;
}

void Fill(const Placed& placed, Tree& tree) {
  Node& node = *new (&tree.memory[placed.at]) Node;
  for (int i = 0; i < width; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool is_there = i < placed.draft->children;
    const Slot& slot = placed.draft->slots[k];
    constexpr float nowhere = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
      node.plane[2 * axis][i] = is_there ? static_cast<float>(slot.box.low[axis]) : nowhere;
      node.plane[2 * axis + 1][i] = is_there ? static_cast<float>(slot.box.high[axis]) : -nowhere;
    }
    node.child[i] = is_there ? placed.child[k] : Child::Make(Child::Kind::nothing, 0);
    if (is_there && Child::KindOf(placed.child[k]) == Child::Kind::triangles)
      FillBlock(*new (&tree.memory[Child::Index(placed.child[k])]) TriangleBlock, tree.space, tree.coordinates,
                slot.items.data(), slot.triangles);
  }
}

}  // namespace

void Lay(const Draft& root, Tree& tree) {
  std::uint32_t end = 0;
  const std::vector<Placed> placed = Place(root, tree, end);
  tree.memory = HugeArray<Tree::Unit>(end);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, placed.size(), 64), [&](const auto& r) {
    for (std::size_t i = r.begin(); i != r.end(); ++i) Fill(placed[i], tree);
  });
  tree.is_large = tree.Bytes() > own_cache;
}

}  // namespace ray::bvh
