#pragma once

#include "R2/Color.h"
#include "source/accelerate/World.h"
#include "source/integrate/TraceSettings.h"

namespace ray {

/// Light that reaches a scattering surface by way of mirrors or glass. Light samples cannot find it, only scattered
/// rays that happen to go there. If the emissive shape is small, hardly any do, and noise does not reveal light that
/// none has found yet. So paths that find the brightest of it are counted (RayCounts::caustics): if there are none,
/// that limits how frequent they can be.
struct Caustics {
  double brightest = 0;  // luminance of the emission
  double most = 0;       // luminance that it may add to a pixel; 0 without caustics

  /// Returns true if this is the brightest, or at least half as bright.
  bool Counts(const R2::Color& emission) const { return most > 0 && Luminance(emission) >= brightest / 2; }
};

/// Returns the caustics that mode path can find.
Caustics CausticsOf(const World& world, const TraceSettings& settings);

}  // namespace ray
