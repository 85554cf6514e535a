#pragma once

#include <cstdint>

#include "source/accelerate/twolevel/TwoLevel.h"

namespace ray::wide {

/// Up to eight primitives of any kind in lanes, each represented by a hull: a convex body that contains it, in its own
/// coordinates q = turn p + shift, with p in the structure's, in which its bounding box is [-1, 1]^3 and its
/// R3::Profile bounds it further. A ray that misses the hull misses the primitive.
struct alignas(32) HullBlock {
  float turn[3][3][width], shift[3][width];
  float radius[width], taper[width], bulge[width];
  /// The error bounds. A point where the primitive's own test accepts a ray may lie outside by stretch times a plane
  /// error of the ray (TraversalRay-inl.h) plus the margin, in the hull's coordinates in single precision.
  float stretch[width], margin[width];
  std::uint32_t primitive[width];
  std::uint32_t count = 0;
};

/// Returns true if a primitive's hull is tighter than its box in the structure's coordinates by enough to test it. That
/// applies to rotated primitives; for others the boxes of nodes are nearly as tight.
bool IsHullTighter(const PrimitiveSet& primitives, const Coordinates& coordinates, std::uint32_t primitive);

/// Fills the block with `count` of the primitives, up to `width`.
void FillHulls(HullBlock& block, const PrimitiveSet& primitives, const Coordinates& coordinates,
               const std::uint32_t* which, int count);

}  // namespace ray::wide
