#pragma once

#include <array>

#include "source/film/denoise/Pixels.h"

namespace ray {

/// Noise-free properties of a pixel: means over camera rays of numbers on which its color may depend linearly. The
/// first three are an estimate of the color itself, in its units; the others are approximately in [-1, 1].
using PixelGuide = std::array<float, 10>;

/// The guides of an image.
struct Guides {
  Pixels<PixelGuide> of_stream[2];  // over the same camera rays as each stream's colors
  // The most accurate guides of each stream. If the error is to be measured, they are computed without the other
  // stream, whose colors then show how well this one was filtered.
  Pixels<PixelGuide> best[2];
};

}  // namespace ray
