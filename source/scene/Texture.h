#pragma once

#include <string>

#include "R2/Color.h"
#include "R2/Image.h"
#include "R2/Point.h"
#include "R3/Intersection.h"

namespace ray {

/// An image spread over 0..1 x 0..1 and, unless the surface says otherwise, repeated beyond; u to the right, v up.
struct Texture {
  R2::Image image;
  std::string file{};  // it was read from; empty for none

  /// Bilinear between texel centers: texel k of n has its center at (k + 0.5) / n. Finite for any finite uv.
  R2::Color At(const R2::Point& uv, const R3::VEnds& ends = {}) const;
  R2::Color On(const R3::Intersection& surface) const { return At(surface.uv, surface.v_ends); }
};

}  // namespace ray
