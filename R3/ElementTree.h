#pragma once

#include <vector>

#include "R3/Shape.h"

namespace R3 {

/// A tree of boxes that finds the elements of a shape that a line may meet without testing each of them. Split at the
/// median element along the longest side.
class ElementTree {
 public:
  explicit ElementTree(const Shape& shape);

  /// Returns the elements whose boxes, widened by `pad`, meet the line of the ray, in no particular order. Empty for
  /// rays with infinite numbers.
  ///   pad   absolute, >= 0, in the boxes' units
  std::vector<int> AlongLine(const Ray& ray, double pad) const;

  const Box& Bounds() const { return nodes_.front().box; }

 private:
  struct Node {
    Box box;
    std::size_t first = 0, last = 0;  // indices into elements_, in a leaf
    std::size_t children = 0;         // the first of two consecutive children; 0 for a leaf
  };

  void Build(const Shape& shape);

  std::vector<Node> nodes_;  // the root first
  std::vector<int> elements_;
};

}  // namespace R3
