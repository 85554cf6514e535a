#pragma once

#include "source/film/PixelRectangle.h"

namespace ray {

/// The i-th of rectangles, at most so large, that are spread evenly over a region, however many of them there are.
///   source   Roberts, The unreasonable effectiveness of quasirandom sequences (2018)
PixelRectangle SpreadRectangle(const PixelRectangle& region, int width, int height, int i);

}  // namespace ray
