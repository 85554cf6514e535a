#pragma once

#include "R2/Color.h"
#include "source/accelerate/World.h"
#include "source/integrate/TraceSettings.h"

namespace ray {

/// Light that reaches what scatters it by way of mirrors or glass. No light sample can find it, only scattered rays
/// that happen to go there; where what emits is small, hardly any do, and of light that none has found yet no noise
/// tells. So paths that find the brightest of it are counted (RayCounts::caustics): where there are none, it is known
/// how rare they are at least.
struct Caustics {
  double brightest = 0;  // luminance of what emits
  double most = 0;       // luminance that it may add to a pixel; 0 where there are no caustics

  /// Whether this is the brightest, or half as bright.
  bool Counts(const R2::Color& emission) const { return most > 0 && Luminance(emission) >= brightest / 2; }
};

/// The caustics that mode path can find.
Caustics CausticsOf(const World& world, const TraceSettings& settings);

}  // namespace ray
