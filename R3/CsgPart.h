#pragma once

#include <memory>

#include "R3/CsgOperation.h"
#include "R3/Shape.h"
#include "R3/Transform.h"

namespace R3 {

/// A solid of a Csg, or an operation on the parts that name it their parent.
struct CsgPart {
  static constexpr int no_parent = -1, no_material = -1;

  int parent = no_parent;  // an earlier part
  CsgOperation operation = CsgOperation::unite;
  std::shared_ptr<const Shape> solid{};  // null for an operation
  Transform csg_from_solid{};
  double slack = 0;  // by how much rounding of the frame's matrices may move the solid, in the csg's own units
  int material = no_material;  // of the solid, numbered by the caller; none: that of the whole Csg
};

}  // namespace R3
