#pragma once

#include <vector>

#include "source/accelerate/World.h"

namespace ray {

/// The padding of a node's box that keeps it from culling hits: per_distance * (largest component of the ray's origin
/// in the world) + constant, in the coordinates of the box.
struct NodeBoundsPadding {
  double per_distance = 0, constant = 0;
};

/// Returns the paddings of all nodes. A shape's own test and the tests of the boxes above it use the ray in different
/// frames, each rounded independently, so a hit of the shape may lie outside the box by the rounding of both. In a
/// frame with inverse A and translation a of the inverse, a point of the world no farther than M from the origin in any
/// component is rounded by at most gamma(4) (|A| M + |a|) per axis when mapped into the frame, and the hit of a shape
/// errs by up to 32 u of the same size (R3/Shape.h). Their sum, rounded up to 64 u, is passed up the graph, scaled by
/// each transform on the way, and every frame on the way adds its own; a baked shape adds the rounding of its corners.
/// M is the distance of the ray's origin plus twice that of the node's farthest corner, since there are no hits outside
/// the node's exact box.
std::vector<NodeBoundsPadding> PaddingOfNodes(const World& world);

/// Returns the padding of the boxes, in the world, of shapes in a frame; `reach` is the largest coordinate of such a
/// box.
NodeBoundsPadding WorldBoundsPadding(const R3::Transform& frame, double reach);

}  // namespace ray
