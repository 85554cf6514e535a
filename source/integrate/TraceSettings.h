#pragma once

#include <array>
#include <cstdint>

#include "R3/Vector.h"
#include "source/sample/Sampler.h"
#include "source/scene/Camera.h"

namespace ray {

/// Russian roulette: faint rays end at random, and those that survive count for more, without bias. Off, they are cut
/// at min_luminance, or never. automatic: on for path, off for whitted.
enum class Roulette { automatic, on, off };
inline constexpr std::array roulette_names{"auto", "on", "off"};
constexpr const auto& NamesOf(Roulette) { return roulette_names; }

/// How path finds light that rays can hit: by the next two, combined by multiple importance sampling; by sampling the
/// lights; by sampling the BSDF; or by choosing lights, and directions to an environment, uniformly (to compare with).
enum class LightStrategy { mis, light, bsdf, uniform };
inline constexpr std::array strategy_names{"mis", "light", "bsdf", "uniform"};
constexpr const auto& NamesOf(LightStrategy) { return strategy_names; }

/// How mode path reads what shapes emit: as a radiance, or as mode whitted does, as the full color of a light that
/// shines from each of its points without fall-off.
enum class Emission { radiance, color };
inline constexpr std::array emission_names{"radiance", "color"};
constexpr const auto& NamesOf(Emission) { return emission_names; }

/// What is one lamp where emission is a color: each triangle of an emissive mesh, as the course has it, or the mesh as
/// a whole.
enum class EmissiveMeshes { faces, whole };
inline constexpr std::array emissive_mesh_names{"faces", "whole"};
constexpr const auto& NamesOf(EmissiveMeshes) { return emissive_mesh_names; }

/// The distances that mode zbuffer shows as white and as black.
struct ZBufferRange {
  double near = 0, far = 0;  // both 0: those of the nearest and the farthest surface in the picture

  bool IsOfPicture() const { return near == 0 && far == 0; }
};

/// The tones of mode gooch: b and y of the cool and the warm one, and how much of the surface's own color is in each.
struct GoochTones {
  double blue = 0.55, yellow = 0.3, alpha = 0.25, beta = 0.5;
};

/// Black lines along silhouettes and creases.
struct OutlineSettings {
  double width = 0;      // in pixels; 0: none
  R3::Vector right, up;  // what directions of a pinhole's rays differ by from one pixel to the next
  Camera camera;         // tells it of others, in a picture of this size
  int picture_width = 1, picture_height = 1;
};

/// The course's recursion, and where it ends.
struct TraceSettings {
  std::int64_t max_depth = 3;   // bounces after the camera ray, >= 0; beyond most_bounces it is most_bounces
  double min_luminance = 0.01;  // a child ray is traced when its throughput's luminance is at least this, >= 0
  int shadow_samples = 16;      // rays to each light that has an area, >= 1
  bool shadows = true;
  bool glossy = false;  // reflections are spread over the Phong lobe, not only along its axis
  Emission emission = Emission::radiance;
  bool emissive_solids_light = false;  // as triangles do where emission is a color; as a radiance all that emits does
  EmissiveMeshes emissive_meshes = EmissiveMeshes::faces;
  bool fresnel = false;  // clear surfaces reflect by Fresnel's equations, and all of what they cannot let through
  bool internal_reflection = false;  // and the latter without Fresnel's equations too; else it is lost
  int lights = -1;  // chosen at each point by importance; 0: every light; -1: see LightsChosenByPath, whitted all
  Roulette roulette = Roulette::automatic;
  LightStrategy strategy = LightStrategy::mis;
  SamplerKind sampler = SamplerKind::sobol;
  ZBufferRange zbuffer;
  GoochTones gooch;
  int toon_bands = 3;  // tones of mode toon beside darkness, >= 1
  double hatch_spacing = 6;  // of strokes of mode hatching, in pixels, > 0
  OutlineSettings outline;
  std::uint32_t samples = 1;  // camera rays per pixel, as far as known; stratified points are laid out for it
};

/// In mode path: of `count` lights, how many each point chooses by importance, or 0 where it samples them all. Of two
/// to four lights, sampling all is 1.2 to 1.6 times as efficient (1 / (relative squared error times seconds)) as
/// choosing one, of eight as efficient, and of sixty-four four times less.
constexpr int LightsChosenByPath(const TraceSettings& settings, int count) {
  constexpr int few = 4;
  if (settings.lights >= 0) return settings.lights;
  return count <= few && settings.strategy != LightStrategy::uniform ? 0 : 1;
}

/// Hard limits that keep mirrors facing each other, at any max_depth, from running forever.
inline constexpr int most_bounces = 1000;        // one after another; beyond, RayCounts::throughput_cut
inline constexpr int most_descendants = 10'000;  // of one camera ray, shadow rays not counted; beyond, RayCounts::cut

}  // namespace ray
