#pragma once

#include <array>
#include <cstdint>

#include "R3/Vector.h"
#include "source/sample/Sampler.h"
#include "source/scene/Camera.h"

namespace ray {

/// Russian roulette: faint rays end at random, and the survivors count for more, without bias. Without it, they are cut
/// at min_luminance, or never. automatic: on for path, off for whitted.
enum class Roulette { automatic, on, off };
inline constexpr std::array roulette_names{"auto", "on", "off"};
constexpr const auto& NamesOf(Roulette) { return roulette_names; }

/// The way in which path finds light that rays can hit.
///   mis       the next two, combined by multiple importance sampling
///   light     sampling the lights
///   bsdf      sampling the BSDF
///   uniform   choosing lights, and directions to an environment, uniformly, for comparison
enum class LightStrategy { mis, light, bsdf, uniform };
inline constexpr std::array strategy_names{"mis", "light", "bsdf", "uniform"};
constexpr const auto& NamesOf(LightStrategy) { return strategy_names; }

/// The meaning of emission in mode path: a radiance, or as in mode whitted, the full color of a light that shines from
/// each of the shape's points without attenuation.
enum class Emission { radiance, color };
inline constexpr std::array emission_names{"radiance", "color"};
constexpr const auto& NamesOf(Emission) { return emission_names; }

/// The light of an emissive mesh whose emission is a color: one for each triangle, as the course has it, or one for the
/// whole mesh.
enum class EmissiveMeshes { faces, whole };
inline constexpr std::array emissive_mesh_names{"faces", "whole"};
constexpr const auto& NamesOf(EmissiveMeshes) { return emissive_mesh_names; }

/// The distances that mode zbuffer shows as white and as black.
struct ZBufferRange {
  double near = 0, far = 0;  // both 0: the nearest and the farthest surface in the image

  bool IsOfImage() const { return near == 0 && far == 0; }
};

/// The tones of mode gooch: b and y of the cool and the warm one, and the share of the surface's own color in each.
struct GoochTones {
  double blue = 0.55, yellow = 0.3, alpha = 0.25, beta = 0.5;
};

/// Black lines along silhouettes and creases.
struct OutlineSettings {
  double width = 0;      // in pixels; 0: none
  R3::Vector right, up;  // differences of a pinhole's ray directions between adjacent pixels
  Camera camera;         // provides them for other cameras, in an image of this size
  int image_width = 1, image_height = 1;
};

/// The course's recursion, and its limits.
struct TraceSettings {
  std::int64_t max_depth = 3;   // bounces after the camera ray, >= 0; limited to most_bounces
  double min_luminance = 0.01;  // minimum luminance of a child ray's throughput, >= 0
  int shadow_samples = 16;      // rays to each light with an area, >= 1
  bool shadows = true;
  bool glossy = false;  // spread reflections over the Phong lobe instead of its axis alone
  Emission emission = Emission::radiance;
  // like triangles if emission is a color; if it is a radiance, all emissive shapes are lights
  bool emissive_solids_light = false;
  EmissiveMeshes emissive_meshes = EmissiveMeshes::faces;
  // clear surfaces reflect by Fresnel's equations, and all light that they cannot transmit
  bool fresnel = false;
  // reflect light that cannot be transmitted even without Fresnel's equations; otherwise it is lost
  bool internal_reflection = false;
  // chosen at each point by importance; 0: every light; -1: LightsChosenByPath; in mode whitted all
  int lights = -1;
  Roulette roulette = Roulette::automatic;
  LightStrategy strategy = LightStrategy::mis;
  SamplerKind sampler = SamplerKind::sobol;
  ZBufferRange zbuffer;
  GoochTones gooch;
  int toon_bands = 3;        // tones of mode toon in addition to darkness, >= 1
  double hatch_spacing = 6;  // spacing of strokes in mode hatching, in pixels, > 0
  OutlineSettings outline;
  // camera rays per pixel, if known; stratified points are laid out for this number
  std::uint32_t samples = 1;
};

/// Returns how many of `count` lights each point chooses by importance in mode path, or 0 if it samples them all. With
/// two to four lights, sampling all is 1.2 to 1.6 times as efficient (1 / (relative squared error times seconds)) as
/// choosing one. With eight, it is equally efficient; with sixty-four, four times less.
constexpr int LightsChosenByPath(const TraceSettings& settings, int count) {
  constexpr int few = 4;
  if (settings.lights >= 0) return settings.lights;
  return count <= few && settings.strategy != LightStrategy::uniform ? 0 : 1;
}

/// Hard limits, for any max_depth, so that rays between mirrors that face each other end.
inline constexpr int most_bounces = 1000;        // of one path; beyond, RayCounts::throughput_cut
inline constexpr int most_descendants = 10'000;  // of one camera ray, without shadow rays; beyond, RayCounts::cut

}  // namespace ray
