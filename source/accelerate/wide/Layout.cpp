#include "source/accelerate/wide/Layout.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <vector>

namespace ray::wide {
namespace {

constexpr std::uint32_t units_of_node = sizeof(Node) / unit, units_of_block = sizeof(TriangleBlock) / unit;
constexpr std::uint32_t units_of_sphere = sizeof(SphereLeaf) / unit;
constexpr std::uint32_t most_units = (std::uint32_t{1} << Child::kind_shift) - 64;
constexpr std::size_t own_cache = std::size_t{1} << 22;  // of a core, about

struct NodeAt {
  const BuildNode* node;
  std::uint32_t first_unit;
  std::array<std::uint32_t, width> child;
};
struct BlockAt {
  const BuildChild* child;
  std::uint32_t first_unit;
};
struct SphereAt {
  std::uint32_t primitive, first_unit;
};

/// Gives nodes, blocks and spheres their units of memory, one child and what is below it after the other.
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
      if (end > most_units) throw std::length_error("the scene is too large: its tree would take more than 32 GB");
      for (std::size_t i = children; i-- > 0;)
        if (const BuildNode* below = next.node->children[i].below) stack.push_back({below, self, i, next.depth + 1});
    }
    return top;
  }

  std::vector<NodeAt> nodes;
  std::vector<BlockAt> blocks;
  std::vector<SphereAt> spheres;
  std::uint32_t end = 0;

 private:
  struct StackEntry {
    const BuildNode* node;
    std::size_t parent, child;
    int depth;
  };

  std::uint32_t AddLeaf(const BuildChild& child) {
    if (child.triangles == 0) return AddPrimitive(child.primitives[0]);
    const std::uint32_t self = Child::Make(Child::Kind::triangles, end);
    blocks.push_back({&child, end});
    end += units_of_block;
    return self;
  }

  std::uint32_t AddPrimitive(std::uint32_t primitive) {
    if (!tree_.primitives.SphereOf(primitive)) return Child::Make(Child::Kind::primitive, primitive);
    const std::uint32_t self = Child::Make(Child::Kind::sphere, end);
    spheres.push_back({primitive, end});
    end += units_of_sphere;
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

template <typename Body>
void ForAll(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 64), [&](const auto& r) {
    for (std::size_t i = r.begin(); i != r.end(); ++i) body(i);
  });
}

}  // namespace

std::vector<std::uint32_t> Flatten(std::span<const BuildChild> roots, Tree& tree) {
  LayoutPass layout(tree);
  std::vector<std::uint32_t> children;
  children.reserve(roots.size());
  for (const BuildChild& root : roots) children.push_back(layout.Add(root));
  tree.memory = HugeArray<Tree::Unit>(layout.end);
  tree.nodes = layout.nodes.size(), tree.blocks = layout.blocks.size();
  ForAll(layout.nodes.size(), [&](std::size_t i) { Fill(layout.nodes[i], tree); });
  ForAll(layout.blocks.size(), [&](std::size_t i) {
    const auto& [child, first_unit] = layout.blocks[i];
    FillBlock(*new (&tree.memory[first_unit]) TriangleBlock, tree.primitives, tree.coordinates,
              child->primitives.data(), child->triangles);
  });
  ForAll(layout.spheres.size(), [&](std::size_t i) {
    const auto& [primitive, first_unit] = layout.spheres[i];
    new (&tree.memory[first_unit]) SphereLeaf(*tree.primitives.SphereOf(primitive));
  });
  tree.is_large = tree.Bytes() > own_cache;
  return children;
}

}  // namespace ray::wide
