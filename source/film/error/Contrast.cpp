#include "source/film/error/Contrast.h"

#include <algorithm>
#include <cmath>

namespace ray {

std::vector<double> NeighborContrasts(const Film& film, const ErrorMeasure& measure) {
  const R2::Image image = film.Image();
  const PixelRectangle& region = film.Region();
  std::vector<double> contrasts(static_cast<std::size_t>(film.Blocks()), 0);
  const auto note = [&](int x, int y, int next_x, int next_y) {
    const R2::Color a = image.At(x, y), b = image.At(next_x, next_y);
    const auto apart = [&](double p, double q) { return std::abs(AsMeasured(p, measure) - AsMeasured(q, measure)); };
    const double contrast = std::max({apart(a.r, b.r), apart(a.g, b.g), apart(a.b, b.b)});
    for (const int block :
         {film.BlockOf(region.x0 + x, region.y0 + y), film.BlockOf(region.x0 + next_x, region.y0 + next_y)}) {
      double& most = contrasts[static_cast<std::size_t>(block)];
      most = std::max(most, contrast);
    }
  };
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      if (x + 1 < image.Width()) note(x, y, x + 1, y);
      if (y + 1 < image.Height()) note(x, y, x, y + 1);
    }
  return contrasts;
}

}  // namespace ray
