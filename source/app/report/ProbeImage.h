#pragma once

#include <cstddef>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/PixelRectangle.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// A square of an image, rendered to tell what all of it would cost.
struct ProbedSquare {
  PixelRectangle pixels;
  double seconds = 0;  // of one processor
  double square = 0;   // mean squared error: as displayed, of values in 0..1, or of light where the target is
  double mean = 0;     // of the channels
};

/// Renders squares of the image, or of its crop, that are spread over it, one after another by one thread: each at
/// settings.samples, in two streams so that its error is measured, whatever the budget; filtered where settings ask for
/// it. The first squares are the same for all settings of one size, so that these can be compared square by square.
///   seconds   of one processor, after which no square is begun but the first
///   most      squares, at least 1
///   source    the order of squares: Roberts, The unreasonable effectiveness of quasirandom sequences (2018), R2
std::vector<ProbedSquare> ProbeImage(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                                     double seconds, std::size_t most);

}  // namespace ray
