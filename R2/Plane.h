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
inline double Mean(const Plane& plane) {
  double sum = 0;
  for (const float value : plane.values) sum += value;
  return plane.values.empty() ? 0 : sum / static_cast<double>(plane.values.size());
}

}  // namespace R2
