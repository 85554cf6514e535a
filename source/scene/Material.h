#pragma once

#include <memory>

#include "R2/Color.h"
#include "source/scene/Texture.h"

namespace ray {

/// A line of a .scn file, field for field. The defaults are the course's gray, used where nothing is inherited.
struct Material {
  R2::Color ka{0.2, 0.2, 0.2};  // ambient reflectance
  R2::Color kd{0.5, 0.5, 0.5};  // diffuse reflectance; a texture multiplies it
  R2::Color ks{0.5, 0.5, 0.5};  // weight of the Phong lobe and of the mirror direction
  R2::Color kt{0, 0, 0};        // weight of what is seen through the surface
  R2::Color emission{0, 0, 0};
  double n = 10;  // Phong exponent, >= 0
  double ir = 1;  // index of refraction against 1 outside, > 0
  std::shared_ptr<const Texture> texture;
  R2::Color absorb{0, 0, 0};  // what the inside takes from light, per unit of length; by the extension of that name
  std::shared_ptr<const Texture> bump;  // its luminance times bump_height is how far the surface seems to rise
  double bump_height = 0;
};

}  // namespace ray
