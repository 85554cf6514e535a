#pragma once

#include "R2/Image.h"
#include "source/film/Filter.h"

namespace ray {

/// Returns an image of another size. Each pixel is the weighted mean of those around its place in the old image. The
/// filter is measured in pixels of the smaller of the two images, so that shrinking skips no pixel. Values are averaged
/// as they are, so linear values are averaged as light. The box weighs by area, which keeps the mean of the image up to
/// the rounding of floats; mitchell and lanczos may overshoot at edges, also below 0.
///   width, height   at least 1, product at most R2::max_pixels (asserted by R2::Image)
///   source          Heckbert, Fundamentals of Texture Mapping and Image Warping (1989), ch. 3
R2::Image Resized(const R2::Image& image, int width, int height, FilterKind filter);

}  // namespace ray
