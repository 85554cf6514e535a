#pragma once

#include <cstdint>

#include "R3/MeshData.h"

/// Grids of triangles, for Shape::Tessellate.
namespace R3 {

struct GridCorner {
  Point position;
  Normal normal;  // unit, outward
  R2::Point uv;
};

/// Adds `columns` x `rows` squares of two triangles each. Their front is the side from which columns run to the right
/// and rows upward. corner(column, row), from 0 up to and including `columns` and `rows`, returns a GridCorner.
/// Triangles with two coincident corners, as at a sphere's poles, are omitted, so a surface of several grids is closed
/// if their rims are bit-identical.
template <typename Corner>
void AddGrid(MeshData& data, int columns, int rows, const Corner& corner) {
  const auto first = static_cast<std::uint32_t>(data.positions.size());
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      const GridCorner made = corner(column, row);
      data.positions.push_back(made.position);
      data.normals.push_back(made.normal);
      data.uvs.push_back(made.uv);
    }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto &p = data.positions[a], &q = data.positions[b], &r = data.positions[c];
    if (!(p == q || q == r || r == p)) data.triangles.push_back({a, b, c});
  };
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row)
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t below = first + row * stride + column, above = below + stride;
      add(below, below + 1, above + 1);
      add(below, above + 1, above);
    }
}

}  // namespace R3
