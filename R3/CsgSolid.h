#pragma once

#include <cstdint>

#include "R3/CsgPart.h"
#include "R3/ElementTree.h"

namespace R3 {

/// A solid of a Csg, with the precomputed values that all rays need.
struct CsgSolid {
  /// Makes the solid of a part that has one; the part must outlive it.
  CsgSolid(const CsgPart& of, std::uint32_t number);

  /// A bound on the distance of crossings from the surface, in the csg's frame: base + share * f, where f is the
  /// largest coordinate of the ray's origin.
  struct Pad {
    double base = 0, share = 0;
  };
  Pad PadOfCrossings() const;

  const CsgPart* part;
  std::uint32_t number;  // of the part
  ElementTree elements;
  bool has_one_element, is_in_place;  // in the csg's frame
  Point center;                       // of the solid's box in its own frame
  double radius, reach;               // half the box's diagonal; its largest coordinate
  Box bounds;                         // in the csg's frame, including the rounding error of the frame
};

}  // namespace R3
