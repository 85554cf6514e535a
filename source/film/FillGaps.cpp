#include "source/film/FillGaps.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

#include "source/film/BlockOrder.h"

namespace ray {
namespace {

struct Offset {
  int x, y;
};

class Filler {
 public:
  Filler(R2::Image& image, int x0, int y0, std::vector<char>& is_known)
      : image_(image), x0_(x0), y0_(y0), is_known_(is_known) {}

  /// Fills all pixels from the lattice of the blocks' corners. Each step fills the centers of the lattice's squares
  /// from their corners, then the middles of their sides from both ends and both centers, which halves the spacing of
  /// the lattice.
  ///   source   the midpoints of Fournier, Fussell and Carpenter, Computer rendering of stochastic models (1982),
  ///            without the randomness
  void Refine() {
    for (int h = BlockOrder::side / 2; h > 0; h /= 2) {
      const std::array<Offset, 4> corners{{{-h, -h}, {h, h}, {h, -h}, {-h, h}}};
      const std::array<Offset, 4> ends{{{-h, 0}, {h, 0}, {0, -h}, {0, h}}};
      ForRows(h, [&](int y) {
        if (y / h % 2 == 1) AverageRow(y, h, 2 * h, corners);
      });
      ForRows(h, [&](int y) { AverageRow(y, y / h % 2 == 1 ? 0 : h, 2 * h, ends); });
    }
  }

  /// Fills pixels that have no known neighbor on the lattice: along rows from the nearest known pixel, then rows
  /// without known pixels from those below or above.
  void Spread() {
    tbb::parallel_for(0, image_.Height(), [&](int y) {
      for (int x = 1; x < image_.Width(); ++x) Copy(x - 1, y, x, y);
      for (int x = image_.Width() - 2; x >= 0; --x) Copy(x + 1, y, x, y);
    });
    // By now each row is known completely or not at all.
    for (int y = 1; y < image_.Height(); ++y) CopyRow(y - 1, y);
    for (int y = image_.Height() - 2; y >= 0; --y) CopyRow(y + 1, y);
  }

 private:
  char& IsKnown(int x, int y) {
    return is_known_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.Width()) +
                     static_cast<std::size_t>(x)];
  }

  bool IsKnownAt(int x, int y) {
    return x >= 0 && y >= 0 && x < image_.Width() && y < image_.Height() && IsKnown(x, y);
  }

  /// Calls function(y) for the rows of this image whose row in the whole image is a multiple of `step`. No pixel filled
  /// in one call is read in another.
  template <class Function>
  void ForRows(int step, const Function& function) {
    const int first = (y0_ + step - 1) / step, last = (y0_ + image_.Height() - 1) / step;
    tbb::parallel_for(first, last + 1, [&](int row) { function(row * step); });
  }

  /// Fills the pixels of a row whose column is `offset` plus a multiple of `step`.
  void AverageRow(int y, int offset, int step, const std::array<Offset, 4>& neighbors) {
    const int first = (x0_ - offset + step - 1) / step * step + offset;
    for (int x = first < x0_ ? first + step : first; x < x0_ + image_.Width(); x += step) Average(x, y, neighbors);
  }

  void Average(int x, int y, const std::array<Offset, 4>& neighbors) {
    const int column = x - x0_, row = y - y0_;
    if (IsKnown(column, row)) return;
    std::array<R2::Color, 4> colors;
    std::size_t known = 0;
    for (const Offset& offset : neighbors) {
      const int c = column + offset.x, r = row + offset.y;
      if (!IsKnownAt(c, r)) continue;
      colors[known++] = image_.At(c, r);
    }
    if (known == 0) return;
    R2::Color sum;
    for (std::size_t i = 0; i < known; ++i) sum += colors[i];
    if (known == colors.size()) {
      const double share = ShareOfFirstPair(column, row, neighbors);
      image_.Store(column, row, (share * (colors[0] + colors[1]) + (1 - share) * (colors[2] + colors[3])) / 2);
    } else {
      image_.Store(column, row, sum / static_cast<double>(known));
    }
    IsKnown(column, row) = 1;
  }

  /// Returns the weight of the first pair of opposite neighbors. A pair weighs more if its two pixels are similar,
  /// since at an edge one pair lies along it. Next to traced pixels, the squares of the differences decide, and the
  /// pairs on either side count half; farther away, edges are too uncertain for that.
  ///   accuracy   tests/source/render/EdgesKept.cpp
  double ShareOfFirstPair(int column, int row, const std::array<Offset, 4>& neighbors) {
    const auto [one, other, third, fourth] = neighbors;
    double a = Unlikeness(column, row, one, other), b = Unlikeness(column, row, third, fourth);
    if (std::abs(one.x) <= 1) {
      for (const int step : {-2, 2}) {
        a += 0.5 * Unlikeness(column + step * third.x, row + step * third.y, one, other);
        b += 0.5 * Unlikeness(column + step * one.x, row + step * one.y, third, fourth);
      }
      a *= a, b *= b;
    }
    return a + b > 0 ? b / (a + b) : 0.5;
  }

  /// Returns the squared difference of two neighbors of a place; 0 if one is unknown.
  double Unlikeness(int column, int row, const Offset& one, const Offset& other) {
    const int x0 = column + one.x, y0 = row + one.y, x1 = column + other.x, y1 = row + other.y;
    if (!IsKnownAt(x0, y0) || !IsKnownAt(x1, y1)) return 0;
    const R2::Color d = image_.At(x0, y0) - image_.At(x1, y1);
    return d.r * d.r + d.g * d.g + d.b * d.b;
  }

  void Copy(int from_x, int from_y, int x, int y) {
    if (IsKnown(x, y) || !IsKnown(from_x, from_y)) return;
    image_.Store(x, y, image_.At(from_x, from_y));
    IsKnown(x, y) = 1;
  }

  void CopyRow(int from, int to) {
    if (IsKnown(0, to) || !IsKnown(0, from)) return;
    for (int x = 0; x < image_.Width(); ++x) Copy(x, from, x, to);
  }

  R2::Image& image_;
  const int x0_, y0_;
  std::vector<char>& is_known_;
};

}  // namespace

void FillGaps(R2::Image& image, int x0, int y0, std::vector<char> is_known) {
  Filler filler(image, x0, y0, is_known);
  filler.Refine();
  filler.Spread();
}

}  // namespace ray
