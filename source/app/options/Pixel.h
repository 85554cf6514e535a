#pragma once

namespace ray {

/// The place of a pixel in an image.
struct Pixel {
  int x = 0, y = 0;  // column from the left, row from the bottom
};

}  // namespace ray
