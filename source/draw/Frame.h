#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "R2/Image.h"

namespace ray {

/// An image that one thread writes while others read it. Each row has a version that counts how often it was written.
class Frame {
 public:
  /// Creates a black image with all versions 0.
  Frame(int width, int height) : image_(width, height), versions_(static_cast<std::size_t>(height)) {}

  int Width() const { return image_.Width(); }
  int Height() const { return image_.Height(); }
  /// Writes rows of the image's width from `first` up. Row 0 is the bottom row.
  void Put(const R2::Image& rows, int first);
  /// Returns the current image.
  R2::Image Image() const;
  R2::Color At(int x, int y) const;
  std::uint32_t Version(int row) const;
  /// Appends rows first .. first + count - 1 as r g b.
  void Copy(int first, int count, std::vector<float>& rgb) const;

 private:
  mutable std::mutex mutex_;
  R2::Image image_;
  std::vector<std::uint32_t> versions_;
};

}  // namespace ray
