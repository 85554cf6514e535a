#include "R3/ShapeKind.h"

#include <array>
#include <cassert>

#include "R1/Kinds.h"

namespace R3 {

std::span<const ShapeKind* const> ShapeKinds() {
#define SHAPE(name) KIND(ShapeKind, name##_kind),
  static const std::array kinds{
#include "R3/shapes.def"
  };
  return kinds;
}

const ShapeKind* FindShapeKind(const std::string& name) { return R1::FindKind(ShapeKinds(), name); }

std::unique_ptr<const Shape> MakeShape(const std::string& name, std::vector<double> arguments) {
  const ShapeKind* kind = FindShapeKind(name);
  assert(kind && kind->Takes(arguments.size()));
  return kind->make(arguments);
}

}  // namespace R3
