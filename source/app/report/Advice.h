#pragma once

#include <string>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// What -advise prints: renders parts of the image for some seconds, with the settings asked for and with others that
/// suit the scene, and tells of each how noisy the image would be at 16 samples per pixel, how long that takes and how
/// long it takes to get below an error (that of -error, or 2/255); then which options to add. Errors are as those of
/// MeasureError, over a few squares of 32x32 pixels, and taken to fall as the root of the samples.
std::string Advice(const World& world, const Accelerator& accelerator, const RenderSettings& render);

}  // namespace ray
