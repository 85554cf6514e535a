#pragma once

#include <chrono>
#include <optional>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/Film.h"
#include "source/film/denoise/Denoise.h"
#include "source/render/Render.h"

namespace ray {

/// Filters the region of a film that has both parts. Guides are refined in proportion to the samples.
DenoisedPicture DenoiseFilm(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                            const Film& film);

/// Filters the picture of a render that is complete, from its film, and measures what error is left; adds the rays that
/// took. Guides are refined in proportion to the samples, or, where they have an end, by as many rays as there is time
/// for, or as a replay says. Tells the monitor how far it is.
/// Where a library fails, the picture stays as it is, and the result says why; where the monitor asks to stop, it stays
/// too, and the render is no longer complete.
void DenoiseResult(const World& world, const Accelerator& accelerator, const RenderSettings& settings, const Film& film,
                   const ErrorMeasure& measure, std::optional<std::chrono::steady_clock::time_point> end_of_guides,
                   const RenderMonitor& monitor, RenderResult& result);

}  // namespace ray
