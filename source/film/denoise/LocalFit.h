#pragma once

#include "source/film/denoise/Guides.h"
#include "source/film/denoise/Pixels.h"
#include "source/film/denoise/WorkMeter.h"

namespace ray {

/// What a local fit is made of; all pictures are of the same size and must outlive it.
struct LocalFitInput {
  const Pixels<Rgb>& colors;         // one stream
  const Pixels<PixelGuide>& guides;  // over its own camera rays
  const Pixels<PixelGuide>& best;
  const Pixels<Rgb>& compared;  // by what neighbors are likened to each other: made of the same stream
  const Pixels<Rgb>& variance;  // of the noise of `compared`, >= 0
  double strength = 1;          // how many deviations of their noise neighbors may be apart, > 0
};

/// Each pixel by a linear fit of the colors around it to their guides and places, read at the pixel's best guide. What
/// camera rays alone decide, edges and textures, takes the exactness of the best guides; other noise is averaged. A
/// neighbor counts by how like the pixel's surroundings its own are, measured in deviations of the noise. No value
/// leaves the range of those that it is made from.
///   source   Moon, Carr, Yoon, Adaptive rendering based on weighted local regression (2014); Bitterli et al.,
///            Nonlinearly weighted first-order regression for denoising Monte Carlo renderings (2016), section 4;
///            weights by Rousselle, Knaus, Zwicker, Adaptive rendering with non-local means filtering (2012), eq. 3 and
///            4
///   accuracy 1e-5, of colors of about 1, beside the same in double precision (tests/source/film/denoise/LocalFit.cpp);
///            the same bits for any tiles, threads and instruction sets
/// Reports each tile to the meter; once that is stopped, the rest stays black.
Pixels<Rgb> LocalFit(const LocalFitInput& input, WorkMeter& meter);
/// How many tiles that are.
std::int64_t LocalFitTiles(int width, int height);

}  // namespace ray
