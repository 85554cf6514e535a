#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "R2/Point.h"
#include "R3/Normal.h"
#include "R3/Point.h"

namespace R3 {

/// The contents of a mesh as read from a file. Normals, texture coordinates and colors have one entry per position or
/// are empty; lines has one per triangle or is empty.
struct MeshData {
  std::vector<Point> positions;                         // finite
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices below positions.size()
  std::vector<Normal> normals;                          // any length; a zero one does not contribute to blends
  std::vector<R2::Point> uvs;                           // finite
  std::vector<std::array<float, 3>> colors;             // linear red, green and blue, finite and not negative
  std::vector<std::uint32_t> lines;                     // 1-based lines of the file, one per triangle; 0: unknown
  bool is_one_polygon = false;                          // split into triangles; as a lamp it is one surface
};

}  // namespace R3
