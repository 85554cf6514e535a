#pragma once

#include <optional>
#include <string>

#include "R2/Image.h"
#include "R2/ImageFile.h"

namespace ray::grade {

/// What probably makes an image differ from its reference, found from the two alone.
struct Cause {
  std::string name;   // "transposed": for tables
  std::string title;  // "rows and columns are swapped"
  std::string hint;   // where to look; may be empty
  double share = 0;   // of the squared difference that it explains, 0 to 1
};

/// The share that must be explained for a cause to be named.
inline constexpr double named_above = 0.8;

/// Tries what needs no scene: every Mistake that has `of_image`, in either image, turns, orders of channels, a factor,
/// a shift by up to a pixel in steps of a half, and what the formats of the two files lose. Named is the one that
/// leaves the least squared difference of the values for a screen, if it explains more than `named_above` of it.
/// Differences of up to 1.5 of 255 are rounding.
///   returns   nothing where the images are equal or nothing known explains the difference
///   accuracy  a shift by half a pixel is told in smooth images and in most aliased ones, whose edges are noisy: both
///             images are blurred for it. Where an image has a symmetry, what is named may be the symmetric twin
std::optional<Cause> LikelyCause(const R2::DecodedImage& image, const R2::DecodedImage& reference);

}  // namespace ray::grade
