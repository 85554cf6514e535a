#pragma once

#include "source/film/PixelRectangle.h"

namespace ray {

/// Returns number i of a sequence of rectangles of at most the given size that are spread evenly over a region, after
/// any number of them.
///   source   Roberts, The unreasonable effectiveness of quasirandom sequences (2018)
PixelRectangle SpreadRectangle(const PixelRectangle& region, int width, int height, int i);

}  // namespace ray
