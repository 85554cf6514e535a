#pragma once

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/Film.h"
#include "source/render/Render.h"

namespace ray {

/// Filters the picture of a render that is complete, from its film, and measures what error is left; adds the rays that
/// took. Where a library fails, the picture stays as it is, and the result says why.
void DenoiseResult(const World& world, const Accelerator& accelerator, const RenderSettings& settings, const Film& film,
                   const ErrorMeasure& measure, RenderResult& result);

}  // namespace ray
