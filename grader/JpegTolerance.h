#pragma once

#include <vector>

#include "R2/Image.h"

namespace ray::grade {

/// Returns the image after compression as JPEG, of the usual quality unless another one is given.
R2::Image AsJpeg(const R2::Image& image, int quality = 75);

/// Returns the largest loss by compression in the block of each pixel, since another edge in a block may spread its
/// error anywhere within it. In rows from the bottom.
std::vector<double> LossesOf(const R2::Image& compressed, const R2::Image& original);

/// Returns true if almost all pixels of an image differ from the reference by no more than JPEG changes around them.
///   image, reference   of the same size, as displayed
bool DiffersLikeJpeg(const R2::Image& image, const R2::Image& reference);

}  // namespace ray::grade
