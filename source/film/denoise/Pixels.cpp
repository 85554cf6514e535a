#include "source/film/denoise/Pixels.h"

#include <tbb/parallel_for.h>

namespace ray {
namespace {

float Finite(double x) { return static_cast<float>(R2::Storable(x)); }

/// The sums of squares around each pixel of a row, one channel after another.
template <std::size_t count>
class SquaresOfRow {
 public:
  /// Sums squares over the pixels at most `reach` columns and rows from those of row y; over none if `reach` is
  /// negative.
  SquaresOfRow(const Pixels<std::array<float, count>>& values, int y, int reach)
      : width_(values.Width()), reach_(reach), sums_(count * static_cast<std::size_t>(width_)) {
    const int first = std::max(0, y - reach), last = std::min(values.Height() - 1, y + reach);
    rows_ = std::max(0, last - first + 1);
    std::vector<double> columns(sums_.size());
    for (int row = first; row <= last; ++row) {
      const float* from = values.At(0, row).data();
      for (std::size_t i = 0; i < columns.size(); ++i) columns[i] += from[i];
    }
    for (int aside = -reach; aside <= reach; ++aside) {
      // This order is independent of the width, so that a part of an image has the sums of the whole.
      const int begin = std::max(0, -aside), end = width_ - std::max(0, aside);
      for (int i = static_cast<int>(count) * begin; i < static_cast<int>(count) * end; ++i)
        sums_[static_cast<std::size_t>(i)] += columns[static_cast<std::size_t>(i + static_cast<int>(count) * aside)];
    }
  }

  double Sum(int x, std::size_t channel) const { return sums_[count * static_cast<std::size_t>(x) + channel]; }
  double PixelsAround(int x) const {
    const int columns = std::min(width_ - 1, x + reach_) - std::max(0, x - reach_) + 1;
    return static_cast<double>(std::max(0, columns)) * rows_;
  }

 private:
  int width_, reach_, rows_ = 0;
  std::vector<double> sums_;
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
      image.Store(x, y, {c[0], c[1], c[2]});
    }
  return image;
}

template <std::size_t count>
Pixels<std::array<float, count>> MeansAround(const Pixels<std::array<float, count>>& values, int radius, int hole) {
  Pixels<std::array<float, count>> means(values.Width(), values.Height());
  tbb::parallel_for(0, values.Height(), [&](int y) {
    const SquaresOfRow<count> outer(values, y, radius), inner(values, y, hole);
    for (int x = 0; x < values.Width(); ++x) {
      const double pixels = outer.PixelsAround(x) - inner.PixelsAround(x);
      for (std::size_t k = 0; k < count; ++k)
        means.At(x, y)[k] = pixels > 0 ? Finite((outer.Sum(x, k) - inner.Sum(x, k)) / pixels) : values.At(x, y)[k];
    }
  });
  return means;
}
template Pixels<std::array<float, 1>> MeansAround(const Pixels<std::array<float, 1>>&, int, int);
template Pixels<Rgb> MeansAround(const Pixels<Rgb>&, int, int);

}  // namespace ray
