#pragma once

#include "R2/Image.h"

namespace ray::grade {

/// Returns the image after compression as JPEG of the usual quality, 75.
R2::Image AsJpeg(const R2::Image& image);

/// Returns the largest difference of two images within two pixels of a pixel, since compression spreads errors over
/// blocks.
double LargestAround(const R2::Image& a, const R2::Image& b, int x, int y);

/// Returns true if almost all pixels of an image differ from the reference by no more than JPEG changes around them.
///   image, reference   of the same size, as displayed
bool DiffersLikeJpeg(const R2::Image& image, const R2::Image& reference);

}  // namespace ray::grade
