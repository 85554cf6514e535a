#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <deque>
#include <span>
#include <vector>

#include "source/accelerate/wide/Layout.h"

/// Common parts of structures that divide space into cells.
namespace ray::wide {

/// The part of a primitive inside a cell.
struct ClippedPrimitive {
  Extent box;  // within box_rounding
  std::uint32_t primitive = 0;
  Child::Kind kind = Child::Kind::triangles;  // the kind of leaf that it may be in
};
using ClippedPrimitives = std::vector<ClippedPrimitive>;

/// A bound on the rounding of coordinates, about 1 at most, to floats, and of clipping, several times over. Cells need
/// not be smaller.
inline constexpr float box_rounding = 0x1p-22f;

/// Returns a whole primitive.
ClippedPrimitive Unclipped(const Tree& tree, std::uint32_t primitive);

/// Clips a primitive further to a cell, in the tree's coordinates: its box shrinks to the part inside. Returns false if
/// that is empty.
///   source  Sutherland, Hodgman, Reentrant polygon clipping (1974)
bool ClipTo(const R3::Box& cell, const Tree& tree, ClippedPrimitive& clipped);

/// A builder of the subtrees for the contents of cells, in parallel: one leaf if they fit, otherwise nodes whose leaves
/// contain neighbors along the longest side of the whole.
class SubtreeBuilder {
 public:
  /// Builds a subtree, reordering the primitives; an empty child if there are none.
  BuildChild Build(std::span<ClippedPrimitive> primitives);

  /// Allocates a node, which is never moved.
  BuildNode& NewNode() { return nodes_.local().emplace_back(); }

 private:
  BuildChild Group(std::span<const BuildChild> children);

  tbb::enumerable_thread_specific<std::deque<BuildNode>> nodes_;
};

}  // namespace ray::wide
