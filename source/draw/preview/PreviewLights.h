#pragma once

#include <array>
#include <vector>

#include "R2/Color.h"
#include "R3/Vector.h"
#include "source/accelerate/World.h"
#include "source/draw/Drawing.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// A light in the terms of the preview's shader, in a DrawingSpace. The light at a point at the distance d is
///     color (cos a)^exponent / (constant + linear d + quadratic d^2),
/// with a the angle to `direction`, and 0 if cos a is below `least_cosine` or not above 0. With a least_cosine below -1
/// the cosine is ignored, and without attenuation there is no division.
///   source   the lights of source/scene/lights
struct PreviewLight {
  static constexpr double everywhere = -2;  // a least_cosine

  R2::Color color;
  std::array<float, 3> place{};  // of an infinitely far light: the unit vector towards it
  bool is_infinite = false;
  std::array<float, 3> direction{0, 0, 1};  // of its middle, away from the light; unit
  double least_cosine = everywhere, exponent = 0;
  double constant = 1, linear = 0, quadratic = 0;  // for distances in the drawing space
  double radius = 0;                               // of its lamp, within which nothing casts a shadow
};

/// The maximum number of lights of a preview, and of those that cast shadows.
inline constexpr std::size_t most_preview_lights = 8, most_preview_shadows = 2;

struct PreviewLights {
  std::vector<PreviewLight> lights;  // at most most_preview_lights, the strongest first
  int left_out = 0;                  // number of the others
  bool head_light = false;           // the scene has no light: one at the eye illuminates it
};

/// Finds the lights that reach the scene in the settings' mode, as points: extended lights and emissive shapes at their
/// middle, and the triangles of a mesh as one. In mode whitted emissive shapes shine as points without attenuation, in
/// mode path as their area over the squared distance. The strongest light is the one that is brightest at the middle of
/// the scene.
PreviewLights PreviewLightsOf(const World& world, const RenderSettings& settings, const DrawingSpace& space);

/// Returns the view of a light for its shadow map: of the whole scene for a light outside of it, otherwise of 150
/// degrees in its direction or towards the scene's middle.
///   source   Williams, Casting curved shadows on curved surfaces (1978)
ClipMatrix ShadowViewOf(const PreviewLight& light);

}  // namespace ray
