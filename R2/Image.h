#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "R2/Color.h"
#include "R2/ZeroedMemory.h"

namespace R2 {

/// The maximum number of pixels of an image, 2^28. A header that claims more is rejected before any memory is
/// allocated.
inline constexpr std::int64_t max_pixels = std::int64_t{1} << 28;

/// Returns the channel as a rendered image stores it: never infinite, never NaN. Values beyond the largest float become
/// that float; NaN, which would be a bug of ours, becomes 0.
inline double Storable(double channel) {
  constexpr double largest = std::numeric_limits<float>::max();
  return std::isnan(channel) ? 0 : std::clamp(channel, -largest, largest);
}
inline Color Storable(const Color& color) { return {Storable(color.r), Storable(color.g), Storable(color.b)}; }

/// A rectangle of colors. Row 0 is the bottom row, as in the course. Channels are stored as floats (24 bits, more than
/// any supported file format needs); a value set and read back is rounded to float.
class Image {
 public:
  using Floats = std::vector<float, ZeroedMemory<float>>;

  Image() = default;
  /// Makes a black image; width and height at least 1, width * height at most max_pixels (asserted).
  Image(int width, int height);

  int Width() const { return width_; }
  int Height() const { return height_; }

  /// Returns a pixel: x from the left in [0, Width), y from the bottom in [0, Height).
  Color At(int x, int y) const {
    const float* p = &channels_[Index(x, y)];
    return {p[0], p[1], p[2]};
  }
  /// Prefetches a color that is needed soon.
  void Prefetch(int x, int y) const { __builtin_prefetch(&channels_[Index(x, y)]); }
  void Set(int x, int y, const Color& c) {
    float* p = &channels_[Index(x, y)];
    p[0] = static_cast<float>(c.r);
    p[1] = static_cast<float>(c.g);
    p[2] = static_cast<float>(c.b);
  }

  /// Sets a pixel of a rendered image. All rendered pixels are stored by this function, so none is infinite or NaN; Set
  /// keeps whatever a file contains.
  void Store(int x, int y, const Color& c) { Set(x, y, Storable(c)); }

  /// Returns all channels, three floats (r, g, b) per pixel, rows from the bottom, for writers and for byte-by-byte
  /// comparison.
  const Floats& Channels() const { return channels_; }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::size_t Index(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  }

  int width_ = 0, height_ = 0;
  Floats channels_;
};

}  // namespace R2
