#pragma once

#include <vector>

#include "R3/Shape.h"

namespace R3 {

/// Finds the elements of a shape that a line may meet without testing each of them: a tree of boxes, split at the
/// median element along the longest side.
class ElementTree {
 public:
  explicit ElementTree(const Shape& shape);

  /// The elements whose boxes, widened by `pad`, the line of the ray meets, in no particular order. Nothing for rays
  /// with infinite numbers.
  ///   pad   absolute, >= 0, in the boxes' units
  std::vector<int> AlongLine(const Ray& ray, double pad) const;

  const Box& Bounds() const { return nodes_.front().box; }

 private:
  struct Node {
    Box box;
    std::size_t first = 0, last = 0;  // of elements_, in a node without children
    std::size_t children = 0;         // the second of two follows the first; 0: none
  };

  void Build(const Shape& shape);

  std::vector<Node> nodes_;  // the root first
  std::vector<int> elements_;
};

}  // namespace R3
