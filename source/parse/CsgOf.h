#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "source/scene/Node.h"

namespace ray {

/// What scenes call the operations, in the order of CsgOperation.
inline constexpr std::array<std::string_view, 3> csg_operations{"union", "intersection", "difference"};

/// The solid that a node with an operation and all below it make, in the node's own coordinates. Its parts have the
/// materials of their nodes; what inherits from the node itself has none. A group is the union of what is in it; one
/// whose transforms cannot be inverted is empty.
///   csg   whose shapes are bounded and closed, and do not move
std::shared_ptr<const R3::Shape> CsgOf(const Node& csg);

}  // namespace ray
