#pragma once

#include "R2/Image.h"

namespace R2 {

inline Image Filled(int width, int height, const Color& c) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.Set(x, y, c);
  return image;
}

}  // namespace R2
