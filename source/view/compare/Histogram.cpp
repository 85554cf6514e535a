#include "source/view/compare/Histogram.h"

#include <algorithm>
#include <cmath>

namespace ray {
namespace {

std::size_t BinOf(double shown) {
  const double place = std::clamp(shown, 0.0, 1.0) * static_cast<double>(Histogram::bins);
  return std::min(Histogram::bins - 1, static_cast<std::size_t>(place));
}

void Count(const R2::Color& color, double exposure, Histogram& histogram) {
  const std::array channels{color.r, color.g, color.b};
  ++histogram.pixels;
  if (!std::ranges::all_of(channels, [](double c) { return std::isfinite(c); })) {
    ++histogram.not_finite;
    return;
  }
  histogram.mean += color;
  bool is_above = false, is_below = false;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const double shown = channels[i] * exposure;
    ++histogram.counts[i][BinOf(shown)];
    is_above |= shown > 1, is_below |= shown < 0;
    histogram.brightest = std::max(histogram.brightest, channels[i]);
  }
  histogram.above += is_above, histogram.below += is_below;
}

}  // namespace

Histogram HistogramOf(const R2::Image& image, double exposure) {
  Histogram histogram;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) Count(image.At(x, y), exposure, histogram);
  const std::int64_t counted = histogram.pixels - histogram.not_finite;
  if (counted > 0) histogram.mean = (1 / static_cast<double>(counted)) * histogram.mean;
  return histogram;
}

}  // namespace ray
