#pragma once

#include <optional>

#include "R2/Image.h"

namespace ray::grade {

/// The shift of an image relative to its reference, in halves of a pixel.
struct PixelShift {
  int halves_right = 0, halves_up = 0;  // -2 to 2, not both 0
  double share = 0;                     // explained share of the squared difference of the blurred luminances
};

/// Returns the shift that explains most; std::nullopt if none is better than no shift, or if the images are smaller
/// than 24 x 24 pixels.
///   image, reference   of the same size, as displayed
///   accuracy           both are blurred, three times by a binomial of five pixels: half a pixel moves an aliased edge
///                      by
///                      a whole pixel in half of its rows, which only their mean shows
std::optional<PixelShift> BestShift(const R2::Image& image, const R2::Image& reference);

}  // namespace ray::grade
