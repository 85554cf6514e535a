#pragma once

#include <cmath>

#include "R2/Color.h"
#include "R3/Vector.h"
#include "source/scene/Material.h"

namespace ray {

/// What one light adds at a surface, in the course's units (no 1/pi, no normalized lobe):
///     (kd (N.L) + ks (V.R)^n) I_L,   nothing when N.L <= 0, no lobe when V.R <= 0
///   N, L, V   unit: normal on the viewer's side, towards the light, towards the viewer
///   kd        the material's, times its texture
///   source    Phong, Illumination for computer generated pictures (1975), with R the mirror image of L about N
inline R2::Color PhongReflection(const Material& material, const R2::Color& kd, const R3::Vector& N,
                                 const R3::Vector& L, const R3::Vector& V, const R2::Color& irradiance) {
  const double cosine = Dot(N, L);
  if (!(cosine > 0)) return {};
  const double lobe = Dot(V, 2 * cosine * N - L);
  const double highlight = lobe > 0 && !IsBlack(material.ks) ? std::pow(lobe, material.n) : 0;
  return (kd * cosine + material.ks * highlight) * irradiance;
}

}  // namespace ray
