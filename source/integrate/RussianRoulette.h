#pragma once

#include <algorithm>
#include <optional>

#include "R2/Color.h"

namespace ray {

// Russian roulette begins with paths that carry less than this: what it would save before is not worth its noise. With
// 1 instead of a quarter, 16 samples a pixel are 1.2 to 1.8 times less efficient (1 / (relative squared error times
// seconds)) on five scenes, closed rooms and open ones; without roulette closed rooms are, 1.1 to 1.2 times.
inline constexpr double least_certain_throughput = 0.25;

/// With what probability a path of that throughput survives.
inline double SurvivalProbability(const R2::Color& throughput) {
  return std::min(1.0, std::max(std::max(throughput.r, throughput.g), throughput.b) / least_certain_throughput);
}

/// Ends a path at random without bias: the throughput of one that survives grows by as much as it was unlikely to.
///   u         uniform in [0, 1)
///   returns   nothing for a path that ends
///   source    Arvo, Kirk, Particle transport and image synthesis (1990), section 4
inline std::optional<R2::Color> RussianRoulette(const R2::Color& throughput, double survival_probability, double u) {
  if (!(u < survival_probability)) return {};
  return throughput / survival_probability;
}

}  // namespace ray
