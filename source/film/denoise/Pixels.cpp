#include "source/film/denoise/Pixels.h"

#include <tbb/parallel_for.h>

namespace ray {
namespace {

using Sum = std::array<double, 3>;

float Finite(double x) { return static_cast<float>(R2::Storable(x)); }

/// The sums over the pixels of a row and of those below it, left of column x: at (x, y) of rows and columns before.
class SumTable {
 public:
  explicit SumTable(const Pixels<Rgb>& values) : sums_(values.Width() + 1, values.Height() + 1) {
    for (int y = 0; y < values.Height(); ++y) {
      Sum row{};
      for (int x = 0; x < values.Width(); ++x)
        for (std::size_t k = 0; k < row.size(); ++k) {
          row[k] += values.At(x, y)[k];
          sums_.At(x + 1, y + 1)[k] = sums_.At(x + 1, y)[k] + row[k];
        }
    }
  }

  struct Square {
    Sum sum;
    double pixels;
  };
  /// What is in the picture of the pixels at most `reach` columns and rows from x, y.
  Square Around(int x, int y, int reach) const {
    const int x0 = std::max(0, x - reach), x1 = std::min(sums_.Width() - 1, x + reach + 1);
    const int y0 = std::max(0, y - reach), y1 = std::min(sums_.Height() - 1, y + reach + 1);
    Square square{{}, static_cast<double>(x1 - x0) * (y1 - y0)};
    for (std::size_t k = 0; k < square.sum.size(); ++k)
      square.sum[k] = (sums_.At(x1, y1)[k] - sums_.At(x0, y1)[k]) - (sums_.At(x1, y0)[k] - sums_.At(x0, y0)[k]);
    return square;
  }

 private:
  Pixels<Sum> sums_;
};

}  // namespace

Pixels<Rgb> PixelsOf(const R2::Image& image) {
  Pixels<Rgb> pixels(image.Width(), image.Height());
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const R2::Color c = image.At(x, y);
      pixels.At(x, y) = {Finite(c.r), Finite(c.g), Finite(c.b)};
    }
  return pixels;
}

R2::Image ImageOf(const Pixels<Rgb>& pixels) {
  R2::Image image(pixels.Width(), pixels.Height());
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const Rgb& c = pixels.At(x, y);
      image.Set(x, y, {c[0], c[1], c[2]});
    }
  return image;
}

Pixels<Rgb> MeansAround(const Pixels<Rgb>& values, int radius, int hole) {
  const SumTable sums(values);
  Pixels<Rgb> means(values.Width(), values.Height());
  tbb::parallel_for(0, values.Height(), [&](int y) {
    for (int x = 0; x < values.Width(); ++x) {
      const SumTable::Square outer = sums.Around(x, y, radius), inner = sums.Around(x, y, hole);
      const double pixels = outer.pixels - inner.pixels;
      for (std::size_t k = 0; k < 3; ++k)
        means.At(x, y)[k] = pixels > 0 ? Finite((outer.sum[k] - inner.sum[k]) / pixels) : values.At(x, y)[k];
    }
  });
  return means;
}

}  // namespace ray
