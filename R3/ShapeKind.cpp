#include "R3/ShapeKind.h"

#include <array>
#include <cassert>

namespace R3 {

#define SHAPE(name) extern const ShapeKind name##_kind;
#include "R3/shapes.def"
#undef SHAPE

std::span<const ShapeKind* const> ShapeKinds() {
  static const std::array kinds{
#define SHAPE(name) &name##_kind,
#include "R3/shapes.def"
#undef SHAPE
  };
  return kinds;
}

const ShapeKind* FindShapeKind(const std::string& name) {
  for (const ShapeKind* kind : ShapeKinds())
    if (name == kind->name) return kind;
  return nullptr;
}

std::unique_ptr<const Shape> MakeShape(const std::string& name, std::vector<double> arguments) {
  const ShapeKind* kind = FindShapeKind(name);
  assert(kind && kind->Takes(arguments.size()));
  return kind->make(arguments);
}

}  // namespace R3
