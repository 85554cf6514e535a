#include "source/accelerate/twolevel/TwoLevel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <array>
#include <cmath>
#include <limits>

namespace ray {

Coordinates FitCoordinates(const PrimitiveSet& primitives) {
  const R3::Box box = tbb::parallel_reduce(
      tbb::blocked_range<std::uint32_t>(0, primitives.Size(), 4096), R3::Box(),
      [&](const auto& r, R3::Box sum) {
        for (std::uint32_t i = r.begin(); i != r.end(); ++i) sum.Extend(primitives.Bounds(i));
        return sum;
      },
      [](R3::Box a, const R3::Box& b) {
        a.Extend(b);
        return a;
      });
  Coordinates fit;
  if (box.IsEmpty()) return fit;
  fit.center = box.Center();
  // A point has no size; any scale works that resolves the center itself.
  const double half = MaxComponent(Abs(box.Size())) / 2;
  const double size = std::max(half, 0x1p-40 * MaxComponent(Abs(FromOrigin(fit.center))));
  const int exponent = size > 0 ? std::ilogb(size) + 1 : 0;
  fit.scale = std::scalbn(1.0, std::clamp(-exponent, -1022, 1022));
  if (!(fit.scale <= most_scale && fit.scale >= 1 / most_scale)) fit.largest_per_t = 0;
  return fit;
}

void FillBlock(TriangleBlock& block, const PrimitiveSet& primitives, const Coordinates& coordinates,
               const std::uint32_t* triangles, int count) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < width; ++i) {
    const bool is_there = i < count;
    block.primitive[i] = is_there ? triangles[i] : 0;
    std::array<std::uint32_t, 3> positions{};
    R3::Vector corner, edge1, edge2;
    if (is_there) {
      const R3::MeshData& mesh = primitives.MeshOf(triangles[i])->Data();
      positions = mesh.triangles[static_cast<std::size_t>(primitives[triangles[i]].element)];
      const R3::Point& first = mesh.positions[positions[0]];
      corner = coordinates(first);
      edge1 = coordinates.scale * (mesh.positions[positions[1]] - first);
      edge2 = coordinates.scale * (mesh.positions[positions[2]] - first);
    }
    for (std::size_t k = 0; k < 3; ++k) block.positions[k][i] = positions[k];
    for (int axis = 0; axis < 3; ++axis) {
      block.corner[axis][i] = is_there ? static_cast<float>(corner[axis]) : nan;
      block.edge1[axis][i] = static_cast<float>(edge1[axis]);
      block.edge2[axis][i] = static_cast<float>(edge2[axis]);
    }
  }
}

}  // namespace ray
