#include "R3/Mesh.h"
#include "R3/ShapeKind.h"

namespace R3 {

extern const ShapeKind tri_kind{
    "tri",
    "a triangle, counter-clockwise seen from its front",
    {{"x1"}, {"y1"}, {"z1"}, {"x2"}, {"y2"}, {"z2"}, {"x3"}, {"y3"}, {"z3"}},
    [](std::span<const double> a) -> std::unique_ptr<const Shape> {
      MeshData data;
      data.positions = {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}, {a[6], a[7], a[8]}};
      data.triangles = {{0, 1, 2}};
      data.uvs = TriUvs();
      return std::make_unique<Mesh>(std::move(data));
    },
    {-1, -0.5, 0.25, 1.5, -0.75, -0.5, 0.25, 1.25, 0.5},
};

}  // namespace R3
