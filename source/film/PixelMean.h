#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "R2/Color.h"

namespace ray {

/// A pixel under the box filter: the mean of its samples, added in a fixed order.
class PixelMean {
 public:
  void Add(const R2::Color& sample) {
    sum_ += sample;
    ++samples_;
  }

  /// What goes into an image of floats: never infinite, never NaN. Values beyond the largest float become it; a channel
  /// that is no number (which would be a fault of ours) becomes 0.
  R2::Color Value() const {
    const R2::Color mean = sum_ / samples_;
    return {Storable(mean.r), Storable(mean.g), Storable(mean.b)};
  }

 private:
  static double Storable(double x) {
    constexpr double largest = std::numeric_limits<float>::max();
    return std::isnan(x) ? 0 : std::clamp(x, -largest, largest);
  }

  R2::Color sum_;
  int samples_ = 0;
};

}  // namespace ray
