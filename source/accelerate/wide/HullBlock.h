#pragma once

#include <cstdint>

#include "source/accelerate/twolevel/TwoLevel.h"

namespace ray::wide {

/// Up to eight primitives of any kind side by side, each by a hull: a convex body that holds it, in coordinates of its
/// own, q = turn p + shift with p in the structure's, in which its bounding box is [-1, 1]^3 and its R3::Profile says
/// the rest. A ray that misses the hull misses the primitive.
struct alignas(32) HullBlock {
  float turn[3][3][width], shift[3][width];
  float radius[width], taper[width], bulge[width];
  /// A point where the primitive's own test accepts a ray may lie outside by stretch times a plane error of the ray
  /// (TraversalRay-inl.h) plus the margin, in the hull's coordinates as single precision computes them.
  float stretch[width], margin[width];
  std::uint32_t primitive[width];
  std::uint32_t count = 0;
};

/// Whether a primitive's hull is so much tighter than its box in the structure's coordinates that asking it pays; else
/// the boxes of nodes have said nearly as much. That is so of what is turned.
bool IsHullTighter(const PrimitiveSet& primitives, const Coordinates& coordinates, std::uint32_t primitive);

/// `count` of the primitives, up to `width`.
void FillHulls(HullBlock& block, const PrimitiveSet& primitives, const Coordinates& coordinates,
               const std::uint32_t* which, int count);

}  // namespace ray::wide
