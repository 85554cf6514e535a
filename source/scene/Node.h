#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "R3/Box.h"
#include "R3/CsgOperation.h"
#include "R3/Matrix.h"
#include "R3/Segment.h"
#include "R3/Shape.h"
#include "source/scene/Location.h"

namespace ray {

/// A node of the scene graph: a group with children, or one primitive (a shape, or a line for the viewer). A
/// primitive's own transform is the identity. Solids that are combined are the children of a node with an operation;
/// the outermost such node has the combined solid as its shape, which rays hit, and its children record how it was
/// made. Trees 100,000 levels deep are legal: nothing here recurses.
struct Node {
  static constexpr int inherit = -1;

  Node() = default;
  Node(Node&&) noexcept = default;
  Node& operator=(Node&&) noexcept;
  ~Node();

  R3::Vector motion;     // displacement during the shutter interval, at constant speed, in the PARENT's coordinates
  R3::Matrix transform;  // parent from node; covers the children, the shape and the line
  std::shared_ptr<const R3::Shape> shape;     // null for a group
  std::unique_ptr<const R3::Segment> line;    // drawn by the viewer, ignored by the tracer
  int material = inherit;                     // index into Scene::materials, passed on to children that inherit
  std::optional<R3::CsgOperation> operation;  // applied to the children
  R3::Box bounds;                             // in the PARENT's coordinates, over its motion; empty for an empty group
  Location location;
  std::vector<Node> children;
};

/// Sets `bounds` from the shape, the line and the children's bounds (which must be set already): the box around the
/// corners of their union after the node's transform. An empty union stays empty.
void SetBounds(Node& node);

}  // namespace ray
