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
  RayCounts rays;                    // the rays traced
  std::uint64_t following_rays = 0;  // the part of them over the film's camera rays
  double refining_rays_of_use = 0;   // approximate number of the others without a limit
};

/// Returns the limit of refining, given the number of rays over the film's camera rays, after these. std::nullopt:
/// refine in proportion to the camera rays, place by place.
using RefiningBudget = std::function<std::optional<Refinement>(std::uint64_t following_rays)>;

/// Computes the guides of the film's pixels: over the camera rays of the film's samples, equally many of each stream,
/// and at edges over additional ones, which the best guides of both streams share. Filters wider than a pixel are
/// ignored. The result is the same, bit for bit, for any number of threads.
///   refining   returns the limit of additional rays, which are spread so that they help most over the whole film; or
///              std::nullopt to spread them in proportion over the surroundings of each pixel, so that a part of an
///              image has the guides of the whole
///   meter      is notified of parts of rows of pixels; after a stop, the result is unspecified
GatheredGuides GatherGuides(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                            const Film& film, const RefiningBudget& refining, WorkMeter& meter);

}  // namespace ray
