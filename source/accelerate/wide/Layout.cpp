#include "source/accelerate/wide/Layout.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <vector>

#include "source/accelerate/wide/HullBlock.h"

namespace ray::wide {
namespace {

constexpr std::uint32_t units_of_node = sizeof(Node) / unit, units_of_block = sizeof(TriangleBlock) / unit;
constexpr std::uint32_t units_of_sphere = sizeof(SphereLeaf) / unit, units_of_hulls = sizeof(HullBlock) / unit;
constexpr std::uint32_t most_units = (std::uint32_t{1} << Child::kind_shift) - 64;
constexpr std::size_t own_cache = std::size_t{1} << 22;  // approximate private cache of a core

struct NodeAt {
  const BuildNode* node;
  std::uint32_t first_unit;
  std::array<std::uint32_t, width> child;
};
struct LeafAt {
  const BuildChild* child;
  std::uint32_t first_unit;
};

/// Assigns memory units to nodes and leaves, depth-first.
class LayoutPass {
 public:
  explicit LayoutPass(Tree& tree) : tree_(tree) {}

  std::uint32_t Add(const BuildChild& child) {
    if (child.IsEmpty()) return Child::nothing;
    if (!child.below) return AddLeaf(child);
    const std::uint32_t top = Child::Make(Child::Kind::node, end);
    std::vector<StackEntry> stack{{child.below, 0, 0, 1}};
    const std::size_t first = nodes.size();
    while (!stack.empty()) {
      const StackEntry next = stack.back();
      stack.pop_back();
      tree_.depth = std::max(tree_.depth, next.depth);
      if (next.depth > most_depth) throw std::length_error("the scene is too large: its tree would be too deep");
      if (nodes.size() > first) nodes[next.parent].child[next.child] = Child::Make(Child::Kind::node, end);
      const std::size_t self = nodes.size();
      nodes.push_back({next.node, end, {}});
      end += units_of_node;
      const auto children = static_cast<std::size_t>(next.node->count);
      for (std::size_t i = 0; i < children; ++i)
        if (!next.node->children[i].below) nodes[self].child[i] = AddLeaf(next.node->children[i]);
      if (end > most_units) throw std::length_error("the scene is too large: its tree would take more than 16 GB");
      for (std::size_t i = children; i-- > 0;)
        if (const BuildNode* below = next.node->children[i].below) stack.push_back({below, self, i, next.depth + 1});
    }
    return top;
  }

  std::vector<NodeAt> nodes;
  std::vector<LeafAt> leaves;
  std::size_t blocks = 0;  // of triangles
  std::uint32_t end = 0;

 private:
  struct StackEntry {
    const BuildNode* node;
    std::size_t parent, child;
    int depth;
  };

  static std::uint32_t UnitsOf(Child::Kind kind) {
    if (kind == Child::Kind::triangles) return units_of_block;
    return kind == Child::Kind::sphere ? units_of_sphere : units_of_hulls;
  }

  std::uint32_t AddLeaf(const BuildChild& child) {
    if (child.kind == Child::Kind::primitive) return Child::Make(child.kind, child.primitives[0]);
    if (child.kind == Child::Kind::triangles) ++blocks;
    const std::uint32_t self = Child::Make(child.kind, end);
    leaves.push_back({&child, end});
    end += UnitsOf(child.kind);
    return self;
  }

  Tree& tree_;
};

void Fill(const NodeAt& from, Tree& tree) {
  Node& node = *new (&tree.memory[from.first_unit]) Node;
  for (int i = 0; i < width; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool is_there = i < from.node->count;
    const BuildChild& child = from.node->children[k];
    constexpr float nowhere = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
      node.At(2 * axis, i) = is_there ? static_cast<float>(child.box.low[axis]) : nowhere;
      node.At(2 * axis + 1, i) = is_there ? static_cast<float>(child.box.high[axis]) : -nowhere;
    }
    node.child[i] = is_there ? from.child[k] : Child::nothing;
  }
}

void Fill(const LeafAt& from, Tree& tree) {
  const BuildChild& leaf = *from.child;
  const std::uint32_t* const which = leaf.primitives.data();
  void* const place = &tree.memory[from.first_unit];
  if (leaf.kind == Child::Kind::triangles)
    FillBlock(*new (place) TriangleBlock, tree.primitives, tree.coordinates, which, leaf.count);
  else if (leaf.kind == Child::Kind::sphere)
    new (place) SphereLeaf(*tree.primitives.SphereOf(which[0]));
  else
    FillHulls(*new (place) HullBlock, tree.primitives, tree.coordinates, which, leaf.count);
}

template <typename Body>
void ForAll(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 64), [&](const auto& r) {
    for (std::size_t i = r.begin(); i != r.end(); ++i) body(i);
  });
}

}  // namespace

Child::Kind LeafKindOf(const Tree& tree, std::uint32_t primitive) {
  if (tree.primitives.MeshOf(primitive)) return Child::Kind::triangles;
  if (tree.primitives.SphereOf(primitive)) return Child::Kind::sphere;
  return IsHullTighter(tree.primitives, tree.coordinates, primitive) ? Child::Kind::hulls : Child::Kind::primitive;
}

std::vector<std::uint32_t> Flatten(std::span<const BuildChild> roots, Tree& tree) {
  LayoutPass layout(tree);
  std::vector<std::uint32_t> children;
  children.reserve(roots.size());
  for (const BuildChild& root : roots) children.push_back(layout.Add(root));
  tree.memory = HugeArray<Tree::Unit>(layout.end);
  tree.nodes = layout.nodes.size(), tree.blocks = layout.blocks;
  ForAll(layout.nodes.size(), [&](std::size_t i) { Fill(layout.nodes[i], tree); });
  ForAll(layout.leaves.size(), [&](std::size_t i) { Fill(layout.leaves[i], tree); });
  tree.is_large = tree.Bytes() > own_cache;
  return children;
}

}  // namespace ray::wide
