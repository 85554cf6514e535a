#pragma once

#include <string>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/app/options/RenderOptions.h"

namespace ray {

/// Returns the text of -advise. Renders parts of the image for some seconds, as -error would, with the requested
/// settings and with others that suit the scene; forecasts the samples and seconds after which each claims the
/// requested error, by default 2/255; and recommends the fastest.
///   seconds_to_start   of one processor, that a render of the scene takes until its first ray
std::string Advice(const World& world, const Accelerator& accelerator, const RenderOptions& options,
                   double seconds_to_start);

}  // namespace ray
