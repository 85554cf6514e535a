#pragma once

#include "R2/Image.h"
#include "source/film/denoise/DenoiseFilters.h"
#include "source/film/denoise/Guides.h"
#include "source/film/denoise/WorkMeter.h"

namespace ray {

/// A picture without most of its noise. Each stream is filtered for itself, so that the other tells how well.
struct DenoisedPicture {
  R2::Image of_stream[2];

  /// The picture: the mean of both.
  R2::Image Mean() const;
};

/// Filters two independent pictures of the same size and sample counts. Each pixel is that of the picture itself or
/// of one of several filters, whichever has the least error around it as far as the other stream tells; between places
/// of different filters it is blended. The same, bit for bit, for any number of threads and instruction set; what is no
/// finite number is taken for 0 or the largest float, and comes out as a finite number. Throws DenoiserError where a
/// library fails.
///   cost     1.6 processor seconds with AVX-512 or AVX2, 3.1 with SSE4, and 250 megabytes for a megapixel
///   source   two buffers and the choice by their errors: Rousselle, Manzi, Zwicker, Robust denoising using feature and
///            color information (2013), section 5; here each buffer is filtered by weights of its own, which costs some
///            percent of error and makes that choice, and the error told, right on average
DenoisedPicture Denoise(const R2::Image& a, const R2::Image& b, const Guides& guides,
                        const DenoiseFilters& filters = DenoiseFilters());
/// Denoise that reports its progress and can be stopped, except for a library's filters. Once it is stopped, the result
/// is unspecified.
DenoisedPicture Denoise(const R2::Image& a, const R2::Image& b, const Guides& guides, const DenoiseFilters& filters,
                        WorkMeter& meter);

}  // namespace ray
