#pragma once

#include <array>

#include "source/film/denoise/Pixels.h"

namespace ray {

/// What is known of a pixel besides its noisy light: a mean over camera rays of numbers that its color may depend on
/// linearly. The first three are an estimate of the color itself, in its units; the others are in [-1, 1], about.
using PixelGuide = std::array<float, 10>;

/// The guides of a picture.
struct Guides {
  Pixels<PixelGuide> of_stream[2];  // over the very camera rays that each stream's colors come from
  // The most exact guides of each stream. Where it matters they are made without the other stream, whose colors then
  // show how well this one was filtered.
  Pixels<PixelGuide> best[2];
};

}  // namespace ray
