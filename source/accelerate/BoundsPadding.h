#pragma once

#include <vector>

#include "source/accelerate/World.h"

namespace ray {

/// By how much a node's box must be widened so that it culls no hit: per_distance * (largest component of the ray's
/// origin in the world) + constant, in the coordinates the box is in.
struct NodeBoundsPadding {
  double per_distance = 0, constant = 0;
};

/// The paddings of all nodes. A shape's own test and the tests of the boxes above it see the ray in different frames,
/// each rounded for itself, so the hit a shape finds may lie outside the box by the rounding of both. In a frame with
/// inverse A and translation a of the inverse, a point of the world no farther than M from the origin in any component
/// is rounded by at most gamma(4) (|A| M + |a|) per axis when brought into the frame, and the hit of a shape errs by up
/// to 32 u of the same size (R3/Shape.h). Their sum, rounded up to 64 u, is handed up the graph, stretched by each
/// transform on the way, and every frame on the way adds its own; a baked shape adds the rounding of its corners. M is
/// the distance of the ray's origin plus twice that of the node's farthest corner, since hits outside the node's true
/// box do not exist.
std::vector<NodeBoundsPadding> PaddingOfNodes(const World& world);

/// Padding of the boxes, in the world, of shapes in a frame; `reach` is the largest coordinate of such a box.
NodeBoundsPadding WorldBoundsPadding(const R3::Transform& frame, double reach);

}  // namespace ray
