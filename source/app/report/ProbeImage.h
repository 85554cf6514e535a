#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/PixelRectangle.h"
#include "source/render/RenderSettings.h"
#include "source/render/RenderState.h"
#include "source/render/Schedule.h"

namespace ray {

/// Returns the squares of a probe, spread over an image or its crop: all different, at most `most`. If the image is
/// hardly larger than its squares, returns all of it.
///   side     in pixels, a multiple of a block's
///   source   their order: Roberts, The unreasonable effectiveness of quasirandom sequences (2018), R2
std::vector<PixelRectangle> SquaresToProbe(const PixelRectangle& image, int side, std::size_t most);

/// The course of a render, predicted from squares of its image.
struct Probe {
  std::vector<Pass> passes;  // samples per pixel, errors and seconds of one processor for the whole image
  std::optional<Stop> stop;  // std::nullopt if the probe ended first
  double light = 0;          // mean of the squares' pixels
  double square = 0;         // of the squares' error before any filter, after `passes.back()`

  /// The samples and time of a render that reaches a target.
  struct Arrival {
    double samples = 0, seconds = 0;  // as in `passes`; infinite if it does not reach the target
  };
  /// Predicts from the passes when the target is reached, as -error does. At least one pass must have an error.
  Arrival ArrivalAt(const ErrorTarget& target) const;
};

/// Renders the squares with one thread as -error renders the whole image, pass by pass until settings.budget.error is
/// reached: the schedule and the estimate of the error, denoised or not, are the same.
///   seconds   of one processor, after which no pass begins once an error has been measured
Probe ProbeToError(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                   const std::vector<PixelRectangle>& squares, double seconds);

}  // namespace ray
