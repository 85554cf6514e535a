#pragma once

#include "R2/Image.h"
#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// Returns true if settings.flare has an effect. That requires a pinhole camera, which alone has one place in the image
/// for a light source, and a mode that shows light.
inline bool HasFlare(const Camera& camera, const RenderSettings& settings) {
  return settings.flare > 0 && camera.IsPinhole() && ShowsLight(settings.mode);
}

/// Adds lens flares to a finished image. Each light source of the scene that the eye sees has a glow, six streaks, and
/// ghosts of lens elements along the line from it through the middle of the image.
///
/// Their brightness is the source's light that arrives at the eye, times settings.flare, times the fraction of 64
/// shadow rays that arrive. The rays start on a disc around the eye under which the source appears as large as its
/// glow, so that a light fades as it moves behind an edge. Nothing is random, and every pixel depends on the lights
/// alone: a crop has the pixels of the whole image. Lights outside of the image, and emissive shapes, have no flares.
///   source   Hullin, Eisemann, Seidel, Lee, Physically-based real-time lens flare rendering (2011), section 2, for
///            the parts of a flare; the places and colors of ghosts are our choice
void AddFlare(const World& world, const Accelerator& accelerator, const Camera& camera, const RenderSettings& settings,
              R2::Image& image);

/// Returns the flares alone, on black: the image minus this is the image without flares, except for the rounding of
/// floats.
R2::Image FlareAlone(const World& world, const Accelerator& accelerator, const RenderSettings& settings);

}  // namespace ray
