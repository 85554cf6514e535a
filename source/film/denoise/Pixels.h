#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "R2/Image.h"

namespace ray {

/// One value per pixel of an image, in rows from the bottom.
template <typename T>
class Pixels {
 public:
  Pixels() = default;
  Pixels(int width, int height) : width_(width), height_(height), values_(Index(0, height)) {}

  int Width() const { return width_; }
  int Height() const { return height_; }
  const T& At(int x, int y) const { return values_[Index(x, y)]; }
  T& At(int x, int y) { return values_[Index(x, y)]; }
  /// Returns the value of the nearest pixel inside the image.
  const T& Clamped(int x, int y) const { return At(std::clamp(x, 0, width_ - 1), std::clamp(y, 0, height_ - 1)); }
  bool Contains(int x, int y) const { return x >= 0 && x < width_ && y >= 0 && y < height_; }

 private:
  std::size_t Index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_ = 0, height_ = 0;
  std::vector<T> values_;
};

using Rgb = std::array<float, 3>;

/// Returns the image's channels, with values that are not finite replaced by 0 or the largest float.
Pixels<Rgb> PixelsOf(const R2::Image& image);
R2::Image ImageOf(const Pixels<Rgb>& pixels);

/// Returns means over squares of 2 radius + 1 pixels around each pixel, clipped to the image, without the inner 2 hole
/// + 1 pixels. So a mean is independent of the noise of its own pixel. -1 <= hole < radius; -1 means no hole. No bit of
/// a mean depends on pixels elsewhere: a part of an image has the means of the whole.
template <std::size_t count>
Pixels<std::array<float, count>> MeansAround(const Pixels<std::array<float, count>>& values, int radius, int hole);

}  // namespace ray
