#pragma once

#include <memory>
#include <optional>

#include "R2/Color.h"
#include "source/scene/Texture.h"

namespace ray {

/// The appearance of a surface. The defaults are the course's gray, used if nothing is inherited.
struct Material {
  /// The maximum number of rays per glossy reflection: an image with 64 samples per pixel then has 65,536 of them.
  static constexpr int most_gloss_samples = 1024;
  static constexpr int most_priority = 1'000'000;

  R2::Color ka{0.2, 0.2, 0.2};  // ambient reflectance
  R2::Color kd{0.5, 0.5, 0.5};  // diffuse reflectance; a texture multiplies it
  R2::Color ks{0.5, 0.5, 0.5};  // weight of the Phong lobe of lights
  R2::Color kr{0.5, 0.5, 0.5};  // weight of the mirror direction; in a .scn file ks
  R2::Color kt{0, 0, 0};        // weight of the light transmitted through the surface
  R2::Color emission{0, 0, 0};
  double n = 10;  // Phong exponent, >= 0
  double ir = 1;  // index of refraction against 1 outside, > 0
  std::shared_ptr<const Texture> texture;
  R2::Vector texture_scale{1, 1};      // repetitions of all images over 0..1 of u and of v, > 0
  bool texture_multiplies_ka = false;  // not only kd; so do vertex colors
  bool projects_textures = false;      // images are projected onto meshes without coordinates, see Mesh::Projected
  bool one_sided = false;              // surfaces exist only for rays that arrive at their front
  bool has_vertex_colors = false;      // kd is multiplied by the colors of a mesh's vertices
  R2::Color absorb{0, 0, 0};  // absorption inside, per unit of length; by the extension of that name
  int priority = 0;           // where solids overlap, the material with the highest priority counts
  std::shared_ptr<const Texture> bump;  // its luminance times bump_height is the apparent elevation of the surface
  double bump_height = 0;
  std::shared_ptr<const Texture> specular_map;  // multiplies ks and kr
  std::shared_ptr<const Texture> normal_map;    // normals as colors 2 c - 1: along u, along v, outward
  double gloss = 0;       // exponent of the Phong lobe of reflections; 0: mirror, or with -glossy n
  int gloss_samples = 1;  // rays per such reflection, >= 1, in mode whitted
  double coat = 0;        // index of refraction, > 0, of a clear coat over the diffuse layer; 0: none
  std::optional<R2::Color> color;  // the color in mode flat, if it is not kd + kr + kt
};

}  // namespace ray
