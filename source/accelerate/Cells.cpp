#include "source/accelerate/Cells.h"

#include <algorithm>
#include <cmath>

namespace ray {

CellItem::CellItem(const Space& space, const Coordinates& coordinates, std::uint32_t item) {
  const R3::Box bounds = space.Bounds(item);
  const R3::Vector low = coordinates(bounds.low), high = coordinates(bounds.high);
  box_ = {R3::Point{low.x - cell_pad, low.y - cell_pad, low.z - cell_pad},
          R3::Point{high.x + cell_pad, high.y + cell_pad, high.z + cell_pad}};
  const R3::Mesh* mesh = space.MeshOf(item);
  if (!mesh) return;
  is_triangle_ = true;
  const auto corners = mesh->Corners(space[item].element);
  for (std::size_t i = 0; i < 3; ++i) corners_[i] = coordinates(corners[i]);
}

// The cell, widened, and the triangle fall on different sides of a plane across the axis.
bool CellItem::IsApart(const R3::Vector& axis, const R3::Vector& center, const R3::Vector& half) const {
  const double reach = Dot(Abs(axis), half);
  const double a = Dot(axis, corners_[0] - center), b = Dot(axis, corners_[1] - center),
               c = Dot(axis, corners_[2] - center);
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

bool CellItem::MayTouch(const Cell& cell) const {
  if (box_.high.x < cell.low.x || box_.low.x > cell.high.x || box_.high.y < cell.low.y || box_.low.y > cell.high.y ||
      box_.high.z < cell.low.z || box_.low.z > cell.high.z)
    return false;
  if (!is_triangle_) return true;
  const R3::Vector center = 0.5 * (FromOrigin(cell.low) + FromOrigin(cell.high));
  const R3::Vector half = 0.5 * (cell.high - cell.low) + R3::Vector{cell_pad, cell_pad, cell_pad};
  const R3::Vector a = corners_[1] - corners_[0], b = corners_[2] - corners_[1], c = corners_[0] - corners_[2];
  const auto is_apart_across = [&](const R3::Vector& e) {
    return IsApart({0, -e.z, e.y}, center, half) || IsApart({e.z, 0, -e.x}, center, half) ||
           IsApart({-e.y, e.x, 0}, center, half);
  };
  return !(IsApart(Cross(a, b), center, half) || is_apart_across(a) || is_apart_across(b) || is_apart_across(c));
}

Contents CellContents::Add(const Space& space, const Coordinates& coordinates, std::span<const std::uint32_t> all) {
  Contents contents{static_cast<std::uint32_t>(blocks.size()), 0, static_cast<std::uint32_t>(items.size()), 0};
  std::array<std::uint32_t, width> waiting{};
  int count = 0;
  const auto close = [&] {
    if (count == 0) return;
    FillBlock(blocks.emplace_back(), space, coordinates, waiting.data(), count);
    ++contents.blocks;
    count = 0;
  };
  for (const std::uint32_t item : all) {
    if (!space.MeshOf(item)) {
      items.push_back(item);
      ++contents.items;
      continue;
    }
    waiting[static_cast<std::size_t>(count++)] = item;
    if (count == width) close();
  }
  close();
  return contents;
}

}  // namespace ray
