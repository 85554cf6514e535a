#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "R2/Color.h"

namespace ray {

/// A picture that some threads write while others read it: every channel is whole at any time, every row says how often
/// it was written.
class Frame {
 public:
  Frame(int width, int height);

  int Width() const { return width_; }
  int Height() const { return height_; }
  /// Row 0 is the bottom row.
  void Set(int x, int y, const R2::Color& color);
  R2::Color At(int x, int y) const;
  /// To be called once what a row was to show has been set; makes it seen by who reads the version.
  void Touch(int row);
  std::uint32_t Version(int row) const;
  /// Rows first .. first + count - 1 as r g b, appended.
  void Copy(int first, int count, std::vector<float>& rgb) const;

 private:
  int width_, height_;
  std::vector<std::atomic<float>> channels_;
  std::vector<std::atomic<std::uint32_t>> versions_;
};

}  // namespace ray
