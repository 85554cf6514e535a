#pragma once

#include <vector>

#include "R2/Image.h"

namespace ray {

/// Fills the unknown pixels of an image from the known ones. If every block of 8x8 knows the same number of first
/// places of BlockOrder, fills linearly, and along edges rather than across them; otherwise from the nearest known
/// pixels. Without any known pixel, the image is unchanged.
///   x0, y0     the image's lower left pixel in the whole image, whose blocks begin at multiples of 8
///   is_known   one entry per pixel, in rows
void FillGaps(R2::Image& image, int x0, int y0, std::vector<char> is_known);

}  // namespace ray
