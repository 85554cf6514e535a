#pragma once

#include <array>

#include "R2/Color.h"
#include "R3/Vector.h"
#include "source/scene/Environment.h"

namespace ray {

/// What a diffuse surface of reflectance 1 scatters of the light from all around, if nothing is in the way, as a
/// polynomial of the second degree in its unit normal: within 1 % on average of what an environment gives, 9 % at
/// most, for lights that are wider than a point.
///   source   Ramamoorthi, Hanrahan, An efficient representation for irradiance environment maps (2001), eq. 1 to 10,
///            divided by pi
struct DiffuseLight {
  /// Times 1, y, z, x, xy, yz, 3zz - 1, xz, xx - yy.
  std::array<R2::Color, 9> factors{};

  /// At least 0 in each channel.
  R2::Color At(const R3::Vector& N) const;
};

/// Uniform light from all directions.
DiffuseLight DiffuseLightOf(const R2::Color& radiance);
DiffuseLight DiffuseLightOf(const Environment& environment);

/// An image of at most so many columns and rows: each pixel the mean of a block of the original.
R2::Image Shrunk(const R2::Image& image, int width, int height);

}  // namespace ray
