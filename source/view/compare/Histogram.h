#pragma once

#include <array>
#include <cstdint>

#include "R2/Image.h"

namespace ray {

/// The distribution of an image's values, per channel, as shown: times an exposure factor, from 0 to 1.
struct Histogram {
  static constexpr std::size_t bins = 64;

  std::array<std::array<std::int64_t, bins>, 3> counts{};  // of red, green, blue; clipped values are in the end bins
  std::int64_t pixels = 0;
  std::int64_t above = 0;       // pixels with a channel above 1, which is shown as 1
  std::int64_t below = 0;       // pixels with a channel below 0
  std::int64_t not_finite = 0;  // pixels with a NaN or an infinity; they are in no bin
  double brightest = 0;         // of all finite channels, before the exposure
  R2::Color mean{};             // of finite pixels, before the exposure
};

Histogram HistogramOf(const R2::Image& image, double exposure);

}  // namespace ray
