#pragma once

#include <string>

#include "R2/Color.h"
#include "R2/Image.h"
#include "R2/Point.h"
#include "R2/Vector.h"
#include "R3/Intersection.h"

namespace ray {

/// Where a lookup goes.
struct TexturePlace {
  R2::Point uv;
  R3::VEnds v_ends;
};

/// The place of a surface on an image that lies `scale` times over its 0..1 x 0..1. An image that repeats along v ends
/// nowhere; one that repeats along u alone does not meet its own other side at a pole.
inline TexturePlace PlaceOnTexture(const R3::SurfacePoint& surface, const R2::Vector& scale) {
  if (scale.x == 1 && scale.y == 1) return {surface.uv, surface.v_ends};
  const auto scaled = [&](R3::VEnd end) {
    return scale.y != 1 ? R3::VEnd::repeated : end == R3::VEnd::pole ? R3::VEnd::rim : end;
  };
  return {{scale.x * surface.uv.x, scale.y * surface.uv.y}, {scaled(surface.v_ends.low), scaled(surface.v_ends.high)}};
}

/// An image spread over 0..1 x 0..1 and, unless the surface says otherwise, repeated beyond; u to the right, v up.
struct Texture {
  R2::Image image;
  std::string file{};  // it was read from; empty for none

  /// Bilinear between texel centers: texel k of n has its center at (k + 0.5) / n. Finite for any finite uv.
  R2::Color At(const R2::Point& uv, const R3::VEnds& ends = {}) const;
  /// At a place of a surface over whose 0..1 x 0..1 the image lies `scale` times.
  R2::Color On(const R3::SurfacePoint& surface, const R2::Vector& scale) const {
    const TexturePlace place = PlaceOnTexture(surface, scale);
    return At(place.uv, place.v_ends);
  }
};

}  // namespace ray
