#pragma once

#include <optional>

#include "R2/Color.h"

namespace ray {

/// Ends a path at random without bias: the throughput of one that survives grows by as much as it was unlikely to.
///   u         uniform in [0, 1)
///   returns   nothing for a path that ends
///   source    Arvo, Kirk, Particle transport and image synthesis (1990), section 4
inline std::optional<R2::Color> RussianRoulette(const R2::Color& throughput, double survival_probability, double u) {
  if (!(u < survival_probability)) return {};
  return throughput / survival_probability;
}

}  // namespace ray
