#pragma once

#include "source/film/PixelRectangle.h"

namespace ray {

/// An order of the pixels of a block of 8x8, of which every beginning is spread evenly over the block, and over a
/// picture of such blocks: powers of 4 of them are squares of a lattice, powers of 2 between have their centers too
/// (quincunx).
///   source   Bayer, An optimum method for two-level rendition of continuous-tone pictures (1973)
class BlockOrder {
 public:
  static constexpr int side = 8, places = side * side;
  struct Pixel {
    int column, row;
  };

  /// The place of an image's pixel within its block: 0 to places - 1.
  static int PlaceOf(int column, int row) {
    int place = 0;
    for (int bit = 0, half = side / 2; half > 0; ++bit, half /= 2) {
      const int right = (column & half) != 0, up = (row & half) != 0;
      place |= (up << (2 * bit)) | ((right ^ up) << (2 * bit + 1));
    }
    return place;
  }

  /// Where that place is in the block of which `pixels` are a part, not empty; it need not be among them.
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
