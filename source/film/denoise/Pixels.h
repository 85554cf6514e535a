#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "R2/Image.h"

namespace ray {

/// Something of each pixel of a picture, in rows from the bottom.
template <typename T>
class Pixels {
 public:
  Pixels() = default;
  Pixels(int width, int height) : width_(width), height_(height), values_(Index(0, height)) {}

  int Width() const { return width_; }
  int Height() const { return height_; }
  const T& At(int x, int y) const { return values_[Index(x, y)]; }
  T& At(int x, int y) { return values_[Index(x, y)]; }
  /// The nearest pixel of the picture.
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

/// The image's channels; what is no finite number becomes 0, or the largest float.
Pixels<Rgb> PixelsOf(const R2::Image& image);
R2::Image ImageOf(const Pixels<Rgb>& pixels);

/// The means over squares of 2 radius + 1 pixels around each, as far as they are in the picture, without the inner
/// 2 hole + 1: so a mean knows nothing of the noise of its own pixel. -1 <= hole < radius; -1 leaves out nothing. No
/// bit of a mean depends on pixels elsewhere: a part of a picture has the means of the whole.
template <std::size_t count>
Pixels<std::array<float, count>> MeansAround(const Pixels<std::array<float, count>>& values, int radius, int hole);

}  // namespace ray
