#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "R2/Point.h"
#include "R3/Normal.h"
#include "R3/Point.h"

namespace R3 {

/// What a mesh is made of, as a file brings it. Normals, texture coordinates and colors are one per position or none at
/// all, lines one per triangle or none at all.
struct MeshData {
  std::vector<Point> positions;                         // finite
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices below positions.size()
  std::vector<Normal> normals;                          // any length; a zero one has no say in its blends
  std::vector<R2::Point> uvs;                           // finite
  std::vector<std::array<float, 3>> colors;             // linear red, green and blue, finite and not negative
  std::vector<std::uint32_t> lines;                     // of the file, 1-based, of each triangle; 0: unknown
  bool is_one_polygon = false;                          // cut into its triangles: as a lamp it is one
};

}  // namespace R3
