#pragma once

#include <vector>

#include "R2/Image.h"
#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// Whether settings.flare has an effect. Only a pinhole camera knows where in the image a lamp is, and only where a mode
/// shows light a lamp shines.
inline bool HasFlare(const Camera& camera, const RenderSettings& settings) {
  return settings.flare > 0 && camera.IsPinhole() && ShowsLight(settings.mode);
}

/// Adds what light does within a camera's lens to a finished image: around every lamp of the scene that the eye sees, a
/// glow and six streaks, and along the line from it through the middle of the image the ghosts of other lenses.
///
/// How bright they are is what of the lamp's light arrives at the eye, times settings.flare, times the share of 64
/// shadow rays that arrive; they come from a disc about the eye under which the lamp is seen as large as it glows, so
/// that a lamp fades as it goes behind an edge. Nothing is random, and every pixel depends on the lamps alone: a crop
/// has the pixels of the whole. Lamps outside of the image, and shapes that emit, give none.
///   source   Hullin, Eisemann, Seidel, Lee, Physically-based real-time lens flare rendering (2011), section 2, for
///            what there is; where ghosts are, and their colors, is a choice of ours
void AddFlare(const World& world, const Accelerator& accelerator, const Camera& camera, const RenderSettings& settings,
              R2::Image& image);

/// What Render adds to its image for flares, on black: image minus flare is the image without, but for the rounding of
/// floats.
R2::Image FlareAlone(const World& world, const Accelerator& accelerator, const RenderSettings& settings);

}  // namespace ray
