#pragma once

#include <cstddef>
#include <vector>

namespace R2 {

/// One number per pixel. Row 0 is the bottom row, as in Image.
struct Plane {
  Plane() = default;
  Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  float* Row(int y) { return &values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)]; }
  const float* Row(int y) const { return &values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)]; }

  int width = 0, height = 0;
  std::vector<float> values;
};

/// Returns the mean; zero for a plane without pixels.
double Mean(const Plane& plane);

}  // namespace R2
