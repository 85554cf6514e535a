#pragma once

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/Film.h"
#include "source/film/denoise/Guides.h"
#include "source/film/denoise/WorkMeter.h"
#include "source/integrate/RayCounts.h"
#include "source/render/RenderSettings.h"

namespace ray {

struct GatheredGuides {
  Guides guides;
  RayCounts rays;  // that they took
};

/// The guides of the film's pixels: over the camera rays that the film's samples came from, two streams as many each;
/// and, at edges, over others, up to 128 or as many as the samples, which both streams' best guides share. Filters
/// wider than a pixel are left out of account. The same, bit for bit, for any number of threads.
///   most_refining_rays   of all kinds, about, for those others: spread so that they help most
///   meter                told of rows of pixels; once it is stopped, what comes out is of no use
GatheredGuides GatherGuides(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                            const Film& film, std::uint64_t most_refining_rays, WorkMeter& meter);

}  // namespace ray
