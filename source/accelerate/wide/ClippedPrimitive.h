#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <deque>
#include <span>
#include <vector>

#include "source/accelerate/wide/Layout.h"

/// What structures that cut space into cells have in common.
namespace ray::wide {

/// The part of a primitive that lies in a cell.
struct ClippedPrimitive {
  Extent box;  // within box_rounding
  std::uint32_t primitive = 0;
  Child::Kind kind = Child::Kind::triangles;  // of leaves that it may be in
};
using ClippedPrimitives = std::vector<ClippedPrimitive>;

/// Bound on the rounding of coordinates, about 1 at most, to floats, and of cutting, several times over. Cells need not
/// be smaller.
inline constexpr float box_rounding = 0x1p-22f;

/// All of a primitive.
ClippedPrimitive Unclipped(const Tree& tree, std::uint32_t primitive);

/// Clips it further to a cell, in the tree's coordinates: its box shrinks to what of it lies inside. False when nothing
/// does.
///   source  Sutherland, Hodgman, Reentrant polygon clipping (1974)
bool ClipTo(const R3::Box& cell, const Tree& tree, ClippedPrimitive& clipped);

/// Makes subtrees of what lies in cells, in parallel: where it fits, one leaf; otherwise nodes of leaves of primitives
/// that lie next to each other along the longest side of it all.
class SubtreeBuilder {
 public:
  /// Reorders the primitives. Of none it makes an empty child.
  BuildChild Build(std::span<ClippedPrimitive> primitives);

  /// For nodes; stays where it is.
  BuildNode& NewNode() { return nodes_.local().emplace_back(); }

 private:
  BuildChild Group(std::span<const BuildChild> children);

  tbb::enumerable_thread_specific<std::deque<BuildNode>> nodes_;
};

}  // namespace ray::wide
