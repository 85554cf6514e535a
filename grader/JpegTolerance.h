#pragma once

#include "R2/Image.h"

namespace ray::grade {

/// The image as JPEG of the usual quality, 75, gives it back.
R2::Image AsJpeg(const R2::Image& image);

/// The largest difference of two images at a pixel or up to two beside it: compression spreads errors over blocks.
double LargestAround(const R2::Image& a, const R2::Image& b, int x, int y);

/// Whether nearly all pixels of an image differ from the reference by no more than JPEG changes around them.
///   image, reference   of one size, values for a screen
bool DiffersLikeJpeg(const R2::Image& image, const R2::Image& reference);

}  // namespace ray::grade
