#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "R2/Color.h"

namespace ray {

/// A picture that some threads write while others read it: no channel is ever torn, and every row has a version that
/// says how often it was written.
class Frame {
 public:
  /// Black; every version 0.
  Frame(int width, int height);

  int Width() const { return width_; }
  int Height() const { return height_; }
  /// Row 0 is the bottom row. What no float can hold is shown as the film would: NaN as 0.
  void Set(int x, int y, const R2::Color& color);
  R2::Color At(int x, int y) const;
  /// To be called once a row is set: publishes it to whoever reads its version.
  void Touch(int row);
  std::uint32_t Version(int row) const;
  /// Rows first .. first + count - 1 as r g b, appended.
  void Copy(int first, int count, std::vector<float>& rgb) const;

 private:
  std::size_t Index(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  }

  int width_, height_;
  std::vector<std::atomic<float>> channels_;
  std::vector<std::atomic<std::uint32_t>> versions_;
};

}  // namespace ray
