#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "source/accelerate/wide/Tree.h"

/// A tree under construction, and its layout in memory.
namespace ray::wide {

// Four numbers in a vector type of both compilers; the fourth is padding.
using Float4 = float __attribute__((vector_size(16)));
using Whole4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 Least(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 Most(Float4 a, Float4 b) { return a > b ? a : b; }

inline constexpr float infinity = std::numeric_limits<float>::infinity();

/// A box in a structure's coordinates.
struct Extent {
  Float4 low{infinity, infinity, infinity, infinity}, high = -low;

  void Extend(const Extent& o) { low = Least(low, o.low), high = Most(high, o.high); }
  void Extend(Float4 p) { low = Least(low, p), high = Most(high, p); }
  float HalfArea() const {
    const Float4 e = high - low;
    return e[0] * e[1] + e[1] * e[2] + e[2] * e[0];
  }
};

struct BuildNode;

/// Returns the kind of leaf for a primitive of a tree with coordinates. MostOf returns the capacity of such a leaf.
Child::Kind LeafKindOf(const Tree& tree, std::uint32_t primitive);
inline std::uint32_t MostOf(Child::Kind leaf) {
  return leaf == Child::Kind::triangles || leaf == Child::Kind::hulls ? width : 1;
}

/// A child: a node below, or a leaf of one or more primitives of one kind.
struct BuildChild {
  Extent box;
  const BuildNode* below = nullptr;
  Child::Kind kind = Child::Kind::primitive;
  int count = 0;
  std::array<std::uint32_t, width> primitives{};

  bool IsEmpty() const { return box.low[0] > box.high[0]; }
};

/// A node before its layout in memory.
struct BuildNode {
  int count = 0;
  std::array<BuildChild, width> children;

  void Add(const BuildChild& child) { children[static_cast<std::size_t>(count++)] = child; }
};

inline BuildChild ChildOf(const BuildNode& node) {
  BuildChild child;
  child.below = &node;
  for (int i = 0; i < node.count; ++i) child.box.Extend(node.children[static_cast<std::size_t>(i)].box);
  return child;
}

/// Fills the tree, whose primitives and coordinates are set, from the given children and their subtrees: depth-first,
/// each node followed by its blocks. Returns the final children. Throws std::length_error if the tree would be too
/// large or too deep.
std::vector<std::uint32_t> Flatten(std::span<const BuildChild> roots, Tree& tree);

}  // namespace ray::wide
