#pragma once

#include "source/film/denoise/Denoise.h"
#include "source/film/error/ImageError.h"

namespace ray {

/// Measures the error of the mean of a film's two filtered parts, which must be independent and filtered independently.
/// The squared error is the variance of that mean, from the difference of the filtered parts, plus the squared bias
/// common to both: the amount by which the distance of a filtered part from the other unfiltered one exceeds the
/// variance of both, which is unbiased. If the film's noise is too large to show so small a difference, the squared
/// bias is estimated closer to half of the variance, its value for filters that are neither too weak nor too strong.
/// Light that clamping takes from noisy pixels is ignored. Counting it as MeasureError does made estimates of a clipped
/// sun 0.89 to 1.09 of the truth instead of 0.83 to 0.92, and those of fireflies two times too large or no better.
///   accuracy   of 135 renders, 9 seeds of 15 scenes with 16 samples 192 pixels wide, 133 are within 20% of the truth;
///              129
///              with Open Image Denoise alone and 128 with both (script/denoise_table.sh). The estimate is too low if
///              hardly any path has found a bright light, or if most of the light is a sun that clamping cuts
MeasuredError MeasureDenoisedError(const Film& film, const DenoisedImage& denoised, const ErrorMeasure& measure);

}  // namespace ray
