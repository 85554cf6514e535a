#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "source/accelerate/Forest.h"

/// What structures that cut space into cells have in common: which items go into a cell, and how they lie there.
namespace ray {

/// Items go into every cell that they touch when widened by this, in the structure's coordinates. It covers the slack
/// of every ray whose slack is at most half of it; others ask everything.
inline constexpr double cell_pad = 0x1p-17;

struct Cell {
  R3::Point low, high;
};

/// An item as cells see it.
class CellItem {
 public:
  CellItem(const Space& space, const Coordinates& coordinates, std::uint32_t item);

  const Cell& Box() const { return box_; }  // already widened
  /// False only if the item, widened, certainly does not touch the cell.
  ///   source  Akenine-Moller, Fast 3D triangle-box overlap testing (2001): the axes of the box, the triangle's normal,
  ///           and the nine cross products of edges
  bool MayTouch(const Cell& cell) const;

 private:
  bool IsApart(const R3::Vector& axis, const R3::Vector& center, const R3::Vector& half) const;

  Cell box_;
  bool is_triangle_ = false;
  std::array<R3::Vector, 3> corners_;
};

/// What lies in one cell: blocks of triangles and other items, in the arrays of CellContents.
struct Contents {
  std::uint32_t first_block = 0, blocks = 0, first_item = 0, items = 0;
};

struct CellContents {
  std::vector<TriangleBlock> blocks;
  std::vector<std::uint32_t> items;

  Contents Add(const Space& space, const Coordinates& coordinates, std::span<const std::uint32_t> all);
  /// Gives back memory that was kept for more.
  void Close() { blocks.shrink_to_fit(), items.shrink_to_fit(); }
  Contents All() const {
    return {0, static_cast<std::uint32_t>(blocks.size()), 0, static_cast<std::uint32_t>(items.size())};
  }
  std::size_t Bytes() const { return blocks.capacity() * sizeof(TriangleBlock) + items.capacity() * 4; }
};

}  // namespace ray
