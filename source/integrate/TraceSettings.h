#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "source/sample/Sampler.h"

namespace ray {

/// The course's recursion, and where it ends.
struct TraceSettings {
  std::int64_t max_depth = 3;   // bounces after the camera ray, >= 0; beyond most_bounces it is most_bounces
  double min_luminance = 0.01;  // a child ray is traced when its weight's luminance is at least this and above 0
  int shadow_samples = 16;      // rays to each light that has an area, >= 1
  bool shadows = true;
  bool glossy = false;   // reflections are spread over the Phong lobe, not only along its axis
  bool fresnel = false;  // clear surfaces reflect by Fresnel's equations, and all of what they cannot let through
  int lights = -1;       // chosen at each point by importance; 0: every light; -1: whitted all, path one
  std::string roulette = "auto";  // one of roulette_names
  std::string strategy = "mis";   // one of strategy_names
  std::string sampler = "sobol";  // one of sampler_names
  std::uint32_t samples = 1;      // camera rays a pixel, as far as known; stratified points are laid out for it
};

/// Whether faint rays are followed by chance, at no cost in truth: on, off (they are cut at min_luminance, or never),
/// or auto, which is on for path and off for whitted.
inline constexpr std::array roulette_names{"auto", "on", "off"};

/// How path finds light that rays can hit: by both of the next and weighing them, by choosing places on lights, by
/// following scattered rays, or by choosing lights, and directions to an environment, evenly (to compare with).
inline constexpr std::array strategy_names{"mis", "light", "surface", "uniform"};

SamplerKind SamplerNamed(const std::string& name);

/// Hard limits that keep mirrors facing each other, at any max_depth, from running forever. Rays beyond are counted as
/// cut.
inline constexpr int most_bounces = 1000;        // one after another
inline constexpr int most_descendants = 10'000;  // of one camera ray, shadow rays not counted

}  // namespace ray
