#include "R3/Shape.h"

#include "R3/TessellateByRays.h"

namespace R3 {

MeshData Shape::Tessellate(int fineness) const {
  if (IsDegenerate()) return {};
  constexpr int least = 600;
  return TessellateByRays(*this, std::max(least, fineness * fineness));
}

Box Bounds(const Shape& shape) {
  Box box;
  for (int i = 0; i < shape.Elements(); ++i) box.Extend(shape.Bounds(i));
  return box;
}

}  // namespace R3
