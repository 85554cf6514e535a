#pragma once

#include <optional>

#include "R2/Image.h"

namespace ray::grade {

/// By how many halves of a pixel an image lies beside its reference.
struct PixelShift {
  int halves_right = 0, halves_up = 0;  // -2 to 2, not both 0
  double share = 0;                     // of the squared difference of the blurred luminances that it explains
};

/// The shift that explains most; nothing where none does better than no shift, or the images are smaller than 24 x 24
/// pixels.
///   image, reference   of one size, values for a screen
///   accuracy           both are blurred, three times by a binomial of five pixels: an aliased edge that half a pixel
///   moves is moved in
///                      half of its pixels by a whole one, which only their mean shows
std::optional<PixelShift> BestShift(const R2::Image& image, const R2::Image& reference);

}  // namespace ray::grade
