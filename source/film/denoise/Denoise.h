#pragma once

#include "R2/Image.h"
#include "source/film/denoise/DenoiseFilters.h"
#include "source/film/denoise/Guides.h"
#include "source/film/denoise/WorkMeter.h"

namespace ray {

/// A denoised image. The streams are filtered independently, so that each shows the error of the other.
struct DenoisedImage {
  R2::Image of_stream[2];

  /// Returns the image: the mean of both streams.
  R2::Image Mean() const;
};

/// Denoises an image given as two independent images of equal size and sample counts. Each pixel is that of the image
/// itself or of one of several filters, whichever has the least error around it as estimated from the other stream;
/// pixels are blended between places with different filters. The result is the same, bit for bit, for any number of
/// threads and instruction set. Inputs that are not finite are replaced by 0 or the largest float, and the result is
/// finite. Throws DenoiserError if a library fails.
///   cost     1.6 processor seconds with AVX-512 or AVX2, 3.1 with SSE4, and 250 megabytes for a megapixel
///   source   two buffers and the choice by their errors: Rousselle, Manzi, Zwicker, Robust denoising using feature and
///            color information (2013), section 5. Here each buffer is filtered with weights of its own, which costs a
///            few percent of error but makes that choice, and the reported error, unbiased
DenoisedImage Denoise(const R2::Image& a, const R2::Image& b, const Guides& guides,
                      const DenoiseFilters& filters = DenoiseFilters());
/// A variant of Denoise that reports its progress and can be stopped, except during a library's filters. After a stop
/// the result is unspecified.
DenoisedImage Denoise(const R2::Image& a, const R2::Image& b, const Guides& guides, const DenoiseFilters& filters,
                      WorkMeter& meter);

}  // namespace ray
