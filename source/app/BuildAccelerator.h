#pragma once

#include <memory>

#include "source/accelerate/Accelerator.h"
#include "source/app/options/Options.h"

namespace ray {

/// The accelerator that the options ask for, built for about as many rays as they will trace.
std::unique_ptr<const Accelerator> BuildAccelerator(const World& world, const Options& options);

}  // namespace ray
