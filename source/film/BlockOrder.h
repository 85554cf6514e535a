#pragma once

#include "source/film/PixelRectangle.h"

namespace ray {

/// An order of the pixels of an 8x8 block in which every prefix is spread evenly over the block, and over an image of
/// such blocks. Prefixes of 4^n pixels are square lattices; those of 2 * 4^n pixels also contain the centers of the
/// squares (quincunx).
///   source   Bayer, An optimum method for two-level rendition of continuous-tone pictures (1973)
class BlockOrder {
 public:
  static constexpr int side = 8, places = side * side;
  struct Pixel {
    int column, row;
  };

  /// Returns the place of an image's pixel within its block, 0 to places - 1.
  static int PlaceOf(int column, int row) {
    int place = 0;
    for (int bit = 0, half = side / 2; half > 0; ++bit, half /= 2) {
      const int right = (column & half) != 0, up = (row & half) != 0;
      place |= (up << (2 * bit)) | ((right ^ up) << (2 * bit + 1));
    }
    return place;
  }

  /// Returns the pixel at that place of the block that contains `pixels`, which must not be empty. It need not be one
  /// of `pixels`.
  static Pixel PixelAt(int place, const PixelRectangle& pixels) {
    int column = pixels.x0 / side * side, row = pixels.y0 / side * side;
    for (int bit = 0, half = side / 2; half > 0; ++bit, half /= 2) {
      const int up = (place >> (2 * bit)) & 1, right = ((place >> (2 * bit + 1)) & 1) ^ up;
      row += up * half;
      column += right * half;
    }
    return {column, row};
  }
};

}  // namespace ray
