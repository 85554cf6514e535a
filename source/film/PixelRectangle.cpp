#include "source/film/PixelRectangle.h"

#include <algorithm>
#include <cmath>

namespace ray {

PixelRectangle SpreadRectangle(const PixelRectangle& region, int width, int height, int i) {
  constexpr double plastic = 1.32471795724474602596;
  width = std::min(width, region.Width()), height = std::min(height, region.Height());
  const double x = std::fmod(0.5 + i / plastic, 1), y = std::fmod(0.5 + i / (plastic * plastic), 1);
  const int x0 = region.x0 + static_cast<int>(x * (region.Width() - width));
  const int y0 = region.y0 + static_cast<int>(y * (region.Height() - height));
  return {x0, y0, x0 + width, y0 + height};
}

}  // namespace ray
