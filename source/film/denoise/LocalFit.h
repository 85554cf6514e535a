#pragma once

#include "source/film/denoise/Guides.h"
#include "source/film/denoise/Pixels.h"
#include "source/film/denoise/WorkMeter.h"

namespace ray {

/// The inputs of a local fit. All images have the same size and must outlive it.
struct LocalFitInput {
  const Pixels<Rgb>& colors;         // one stream
  const Pixels<PixelGuide>& guides;  // over the same camera rays
  const Pixels<PixelGuide>& best;
  const Pixels<Rgb>& compared;  // colors by which neighbors are compared, from the same stream
  const Pixels<Rgb>& variance;  // of the noise of `compared`, >= 0
  double strength = 1;          // number of standard deviations by which neighbors may differ, > 0
};

/// Fits each pixel: a linear fit of the colors around it to their guides and places, evaluated at the pixel's best
/// guide. Features that camera rays alone determine (edges and textures) are as accurate as the best guides; other
/// noise is averaged. The weight of a neighbor is the similarity of its surroundings to the pixel's own, measured in
/// standard deviations of the noise. No value is outside the range of its inputs.
///   source   Moon, Carr, Yoon, Adaptive rendering based on weighted local regression (2014); Bitterli et al.,
///            Nonlinearly weighted first-order regression for denoising Monte Carlo renderings (2016), section 4;
///            weights by Rousselle, Knaus, Zwicker, Adaptive rendering with non-local means filtering (2012), eq. 3 and
///            4
///   accuracy 1e-5, for colors of about 1, compared with double precision (tests/source/film/denoise/LocalFit.cpp);
///            the same bits for any tiles, threads and instruction sets
/// Reports each tile to the meter. If the meter is stopped, the remaining tiles stay black.
Pixels<Rgb> LocalFit(const LocalFitInput& input, WorkMeter& meter);
/// Returns the number of tiles of that fit.
std::int64_t LocalFitTiles(int width, int height);

}  // namespace ray
