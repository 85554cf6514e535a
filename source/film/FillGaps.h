#pragma once

#include <vector>

#include "R2/Image.h"

namespace ray {

/// Fills pixels of which nothing is known from those that are: where every block of 8x8 knows as many first places of
/// BlockOrder, linearly, and along edges rather than across them; else from whatever is near. Where nothing is known at
/// all the image stays as it is.
///   x0, y0     of the image's lower left pixel in the picture, whose blocks begin at multiples of 8
///   is_known   of each pixel, in rows
void FillGaps(R2::Image& image, int x0, int y0, std::vector<char> is_known);

}  // namespace ray
