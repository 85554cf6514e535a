#pragma once

#include <memory>

#include "R3/CsgOperation.h"
#include "R3/Shape.h"
#include "R3/Transform.h"

namespace R3 {

/// A solid of a Csg, or an operation on the parts that have it as their parent.
struct CsgPart {
  static constexpr int no_parent = -1, no_material = -1;

  int parent = no_parent;  // the index of an earlier part
  CsgOperation operation = CsgOperation::unite;
  std::shared_ptr<const Shape> solid{};  // null for an operation
  Transform csg_from_solid{};
  double slack = 0;  // a bound on the rounding error of the frame's matrices, as a distance in the csg's units
  int material = no_material;  // of the solid, numbered by the caller; no_material: that of the whole Csg
};

}  // namespace R3
