#pragma once

#include <optional>
#include <string>

#include "R2/Image.h"
#include "R2/ImageFile.h"

namespace ray::grade {

/// The probable cause of the difference between an image and its reference, found from the two alone.
struct Cause {
  std::string name;   // for tables: "transposed"
  std::string title;  // for people: "rows and columns are swapped"
  std::string hint;   // a suggestion where to look; may be empty
  double share = 0;   // explained share of the squared difference, 0 to 1
};

/// The share that a cause must explain to be named.
inline constexpr double named_above = 0.8;

/// Tries causes that need no scene: every Mistake with `of_image`, in either image, rotations, orders of channels, a
/// factor, a shift by up to a pixel in steps of a half, and the losses of the two file formats. Returns the one that
/// leaves the least squared difference of displayed values, if it explains more than `named_above` of it. Differences
/// of up to 1.5/255 count as rounding.
///   returns   std::nullopt if the images are equal or no known cause explains the difference
///   accuracy  a shift by half a pixel is found in smooth images and in most aliased ones, whose edges are noisy: both
///             images are blurred for it. If an image has a symmetry, the symmetric twin of the cause may be named
std::optional<Cause> LikelyCause(const R2::DecodedImage& image, const R2::DecodedImage& reference);

}  // namespace ray::grade
