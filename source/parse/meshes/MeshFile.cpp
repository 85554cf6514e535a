#include "source/parse/meshes/MeshFile.h"

#include <algorithm>

namespace ray {

std::vector<std::uint32_t> ValuesOfTriangles(std::span<const TriangleRun> runs, std::size_t triangles,
                                             std::uint32_t before) {
  std::vector<std::uint32_t> values(triangles, before);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t first = runs[i].first_triangle,
                      end = i + 1 < runs.size() ? runs[i + 1].first_triangle : triangles;
    std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(first), end - first, runs[i].value);
  }
  return values;
}

}  // namespace ray
