#pragma once

#include <array>
#include <optional>
#include <vector>

#include "source/accelerate/World.h"
#include "source/draw/Drawing.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// A light as the shader of the preview knows it, in a DrawingSpace. What it sends to a point at the distance d is
///     color (cos a)^exponent / (constant + linear d + quadratic d^2),
/// a being the angle to `direction`, and nothing where cos a is below `least_cosine` or not above 0; with a
/// least_cosine below -1 the cosine does not count, and without attenuation there is no division.
///   source   the lights of source/scene/lights
struct PreviewLight {
  static constexpr double everywhere = -2;  // a least_cosine

  R2::Color color;
  std::array<float, 3> place{};  // of one that is infinitely far: the unit vector towards it
  bool is_infinite = false;
  std::array<float, 3> direction{0, 0, 1};  // of its middle, away from the light; unit
  double least_cosine = everywhere, exponent = 0;
  double constant = 1, linear = 0, quadratic = 0;  // of distances in the drawing space
  double radius = 0;                               // of its sphere or disc
  bool is_disc = false;                            // about its place, across its direction; with a radius > 0
  bool is_flat = false;  // a point, but its shadows are those of the disc of that radius across its direction
  bool casts_shadows = true;
};

/// So many fit into the smallest uniform block that OpenGL 3.3 allows, 16 KiB, four times.
inline constexpr std::size_t most_preview_lights = 64;

struct PreviewLights {
  std::vector<PreviewLight> lights;  // at most most_preview_lights, the strongest first
  int left_out = 0;                  // the others
  bool head_light = false;           // nothing shines in the scene: a light at the eye shows it
};

/// The lights that reach the scene in the settings' mode, as points and discs: sphere lights at their middle, what
/// emits at its middle too, all triangles of a mesh as one. In mode whitted what emits shines as a point without
/// fall-off, in mode path as its area over the square of the distance; see EmissiveTriangle and EmissiveShape. Of what
/// emits, meshes in one plane cast shadows: the others would be in that of their own surface.
/// Strongest is what sends most to the middle of the scene.
PreviewLights PreviewLightsOf(const World& world, const RenderSettings& settings, const DrawingSpace& space);

}  // namespace ray
