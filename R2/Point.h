#pragma once

namespace R2 {

/// A point in the plane: a texture coordinate, a film position, or a pair of random numbers.
struct Point {
  double x = 0, y = 0;

  friend bool operator==(const Point&, const Point&) = default;
};

}  // namespace R2
