#pragma once

#include <algorithm>
#include <cstdint>

namespace ray {

/// A rectangle of pixels: columns x0 <= x < x1 from the left, rows y0 <= y < y1 from the BOTTOM.
struct PixelRectangle {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int Width() const { return x1 - x0; }
  int Height() const { return y1 - y0; }
  std::int64_t Area() const { return static_cast<std::int64_t>(Width()) * Height(); }
  bool Contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
  friend bool operator==(const PixelRectangle&, const PixelRectangle&) = default;
};

/// Returns the intersection of two rectangles; its area is 0 if they are disjoint.
inline PixelRectangle Common(const PixelRectangle& a, const PixelRectangle& b) {
  const int x0 = std::max(a.x0, b.x0), y0 = std::max(a.y0, b.y0);
  return {x0, y0, std::max(x0, std::min(a.x1, b.x1)), std::max(y0, std::min(a.y1, b.y1))};
}

/// Returns the rectangle, extended by `by` pixels on each side.
inline PixelRectangle Grown(const PixelRectangle& r, int by) { return {r.x0 - by, r.y0 - by, r.x1 + by, r.y1 + by}; }

/// Returns the rectangle, with corners at 0 or above, extended to whole squares of pixels.
inline PixelRectangle InSquares(const PixelRectangle& r, int side) {
  return {r.x0 / side * side, r.y0 / side * side, (r.x1 + side - 1) / side * side, (r.y1 + side - 1) / side * side};
}

/// Returns number i of a sequence of rectangles of at most the given size that are spread evenly over a region, after
/// any number of them.
///   source   Roberts, The unreasonable effectiveness of quasirandom sequences (2018)
PixelRectangle SpreadRectangle(const PixelRectangle& region, int width, int height, int i);

}  // namespace ray
