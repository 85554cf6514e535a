#include "source/render/SampleCounts.h"

#include <algorithm>

namespace ray {

std::int64_t PixelsLookedAt(const Film& film, int block) {
  const PixelRectangle pixels = film.PixelsInRegion(block);
  const std::size_t places = film[block].first_samples.size();
  if (pixels.Area() == BlockOrder::places) return static_cast<std::int64_t>(places);  // not at the image's edge
  std::int64_t count = 0;
  for (std::size_t place = 0; place < places; ++place) {
    const auto [column, row] = BlockOrder::PixelAt(static_cast<int>(place), film.PixelsOf(block));
    count += pixels.Contains(column, row);
  }
  return count;
}

SampleCounts CountSamples(const Film& film) {
  SampleCounts counts{~0u, 0, 0};
  double sum = 0, pixels = 0;
  for (int i = 0; i < film.Blocks(); ++i) {
    const auto area = static_cast<double>(film.PixelsInRegion(i).Area());
    if (area == 0) continue;
    const std::uint32_t samples = film[i].Samples();
    const std::int64_t places = PixelsLookedAt(film, i);  // 0 if all have samples
    counts.least = std::min(counts.least, places == film.PixelsInRegion(i).Area() ? 1 : samples);
    counts.most = std::max(counts.most, places > 0 ? 1 : samples);
    sum += area * samples + static_cast<double>(places);
    pixels += area;
  }
  counts.mean = sum / pixels;
  return counts;
}

double SamplesTaken(const Film& film) {
  double sum = 0;
  for (int i = 0; i < film.Blocks(); ++i)
    sum += static_cast<double>(film.PixelsOf(i).Area()) * film[i].Samples() +
           static_cast<double>(film[i].first_samples.size());
  return sum;
}

}  // namespace ray
