#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "source/scene/Node.h"

namespace ray {

/// The names of the operations in scenes, in the order of CsgOperation.
inline constexpr std::array<std::string_view, 3> csg_operations{"union", "intersection", "difference"};

/// Returns the solid that a node with an operation and its subtree define, in the node's own coordinates. Its parts
/// have the materials of their nodes; parts that inherit from the node itself have none. A group is the union of its
/// contents; one whose combined transform is singular is empty.
///   csg   its shapes are bounded and closed, and do not move
std::shared_ptr<const R3::Shape> CsgOf(const Node& csg);

}  // namespace ray
