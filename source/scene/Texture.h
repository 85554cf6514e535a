#pragma once

#include <string>

#include "R2/Color.h"
#include "R2/Image.h"
#include "R2/Point.h"
#include "R2/Vector.h"
#include "R3/Intersection.h"

namespace ray {

/// The coordinates of a texture lookup.
struct TexturePlace {
  R2::Point uv;
  R3::VEnds v_ends;
};

/// Returns the position of a surface point on an image that is repeated `scale` times over 0..1 x 0..1. An image that
/// is repeated along v has no ends; one that is repeated along u alone does not meet its own other side at a pole.
inline TexturePlace PlaceOnTexture(const R3::SurfacePoint& surface, const R2::Vector& scale) {
  if (scale.x == 1 && scale.y == 1) return {surface.uv, surface.v_ends};
  const auto scaled = [&](R3::VEnd end) {
    return scale.y != 1 ? R3::VEnd::repeated : end == R3::VEnd::pole ? R3::VEnd::rim : end;
  };
  return {{scale.x * surface.uv.x, scale.y * surface.uv.y}, {scaled(surface.v_ends.low), scaled(surface.v_ends.high)}};
}

/// An image over 0..1 x 0..1 that is repeated beyond, unless the surface says otherwise; u to the right, v up.
struct Texture {
  R2::Image image;
  std::string file{};  // the file it was read from; empty for none

  /// Returns the bilinear interpolation between texel centers: texel k of n has its center at (k + 0.5) / n. Finite for
  /// any finite uv.
  R2::Color At(const R2::Point& uv, const R3::VEnds& ends = {}) const;
  /// Returns the color at a surface point; the image is repeated `scale` times over the surface's 0..1 x 0..1.
  R2::Color On(const R3::SurfacePoint& surface, const R2::Vector& scale) const {
    const TexturePlace place = PlaceOnTexture(surface, scale);
    return At(place.uv, place.v_ends);
  }
};

}  // namespace ray
