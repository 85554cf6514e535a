#pragma once

#include <cstdint>
#include <functional>
#include <optional>

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
  RayCounts rays;                    // that they took
  std::uint64_t following_rays = 0;  // of them, those over the film's camera rays
  double refining_rays_of_use = 0;   // about how many of the others there would be without a bound
};

/// What refining may take, told how many rays it took to follow the film's camera rays, once that is done. Nothing: in
/// proportion to the camera rays, place by place.
using RefiningBudget = std::function<std::optional<Refinement>(std::uint64_t following_rays)>;

/// The guides of the film's pixels: over the camera rays that the film's samples came from, two streams as many each;
/// and, at edges, over others, which both streams' best guides share. Filters wider than a pixel are left out of
/// account. The same, bit for bit, for any number of threads.
///   refining   tells how many those others may be. They are spread so that they help most: over all of the film, or,
///              in proportion, over what is near each pixel, so that a part of a picture has the guides of the whole
///   meter      told of parts of rows of pixels; once it is stopped, what comes out is of no use
GatheredGuides GatherGuides(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                            const Film& film, const RefiningBudget& refining, WorkMeter& meter);

}  // namespace ray
