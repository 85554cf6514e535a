#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <deque>
#include <span>
#include <vector>

#include "source/accelerate/wide/Layout.h"

/// What structures that cut space into cells have in common.
namespace ray::bvh {

/// Of one item, what lies in one cell.
struct Part {
  Extent box;  // within box_rounding
  std::uint32_t item = 0;
  bool is_triangle = false;
};
using Parts = std::vector<Part>;

/// Of coordinates, which are about 1 at most, to floats, and of cutting; several times over. Cells need not be smaller.
inline constexpr float box_rounding = 0x1p-22f;

/// All of an item.
Part WholePart(const Tree& tree, std::uint32_t item);

/// Cuts a part to a cell, in the tree's coordinates: its box shrinks to what of it lies inside. False when nothing
/// does.
///   source  Sutherland, Hodgman, Reentrant polygon clipping (1974)
bool CutTo(const R3::Box& cell, const Tree& tree, Part& part);

/// Makes children of a tree from parts, in parallel: where they fit, one block of triangles or one item; otherwise
/// nodes of blocks of triangles that lie next to each other along the longest side of it all, and of items.
class Grouping {
 public:
  /// Brings the parts into another order. Of no parts it makes an empty slot.
  BuildChild operator()(std::span<Part> parts);

  /// For nodes; stays where it is.
  BuildNode& NewDraft() { return drafts_.local().emplace_back(); }

 private:
  BuildChild Group(std::span<const BuildChild> slots);

  tbb::enumerable_thread_specific<std::deque<BuildNode>> drafts_;
};

}  // namespace ray::bvh
