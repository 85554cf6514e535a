#pragma once

#include <string>

#include "R2/Image.h"
#include "source/accelerate/Accelerator.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// Returns true if every channel of every pixel is 0.
bool IsWhollyBlack(const R2::Image& image);

/// Returns the likely reason why a render that shows light is completely black, for a warning: "the camera sees ...".
/// Tries changes that would make it bright, in images of at most 32x32 pixels: the camera behind the first surface, and
/// no shadows. Signals end that; the reason is then a guess.
std::string WhyBlack(const World& world, const Accelerator& accelerator, const RenderSettings& settings);

}  // namespace ray
