#pragma once

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "source/film/Film.h"

namespace ray {

/// The blocks of a film, divided into work items: squares of blocks, in rows from the bottom.
class Tiles {
 public:
  /// `side` in pixels, rounded up to whole blocks; 0: a single tile.
  Tiles(const Film& film, int side)
      : film_columns_(film.Columns()), film_rows_(film.Blocks() / std::max(1, film.Columns())) {
    const int whole = std::max(film_columns_, film_rows_);
    side_ = side > 0 ? std::min(whole, 1 + (side - 1) / Film::block_side) : whole;
    columns_ = (film_columns_ + side_ - 1) / side_;
    rows_ = (film_rows_ + side_ - 1) / side_;
    stride_ = std::max(1, static_cast<int>(Count() / std::numbers::phi));
    while (std::gcd(stride_, Count()) > 1) ++stride_;
  }

  int Count() const { return columns_ * rows_; }
  int Columns() const { return columns_; }
  /// Returns the i-th tile of an order in which successive tiles are spread over the film, in steps of the golden
  /// ratio.
  int Spread(int i) const { return static_cast<int>(std::int64_t{i} * stride_ % Count()); }

  std::vector<int> BlocksOf(int tile) const {
    const int c0 = tile % columns_ * side_, r0 = tile / columns_ * side_;
    std::vector<int> blocks;
    for (int r = r0; r < std::min(r0 + side_, film_rows_); ++r)
      for (int c = c0; c < std::min(c0 + side_, film_columns_); ++c) blocks.push_back(r * film_columns_ + c);
    return blocks;
  }

 private:
  int film_columns_, film_rows_, side_, columns_, rows_, stride_;
};

}  // namespace ray
