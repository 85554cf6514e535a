#pragma once

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/Film.h"
#include "source/film/denoise/Guides.h"
#include "source/integrate/RayCounts.h"
#include "source/render/RenderSettings.h"

namespace ray {

struct GatheredGuides {
  Guides guides;
  RayCounts rays;  // that they took
};

/// The guides of the film's pixels: over the camera rays that the film's samples came from, two streams as many each;
/// and, at edges, over others, 128 or as many as the samples, so that the best guides are independent of both streams.
/// Filters wider than a pixel are left out of account. The same, bit for bit, for any number of threads.
GatheredGuides GatherGuides(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                            const Film& film);

}  // namespace ray
