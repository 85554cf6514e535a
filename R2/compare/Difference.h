#pragma once

#include <cstdint>
#include <limits>

#include "R2/Image.h"
#include "R2/Plane.h"

/// Differences between an image x and a reference r of the same size (asserted). Means are over all channels of the
/// pixels that are finite in every compared image; other pixels are counted but not averaged.
namespace R2 {

/// The conversion of pixel values to those sent to a screen.
enum class Display {
  straight,  // clamped to [0, 1]
  srgb,      // clamped to [0, 1], then encoded with the sRGB curve
};

/// Converts a color for display. NaN becomes black, as in 8-bit files.
Color Displayed(const Color& c, Display display);
Image Displayed(const Image& image, Display display);

struct LargestDifference {
  double value = 0;  // |x - r|
  int x = 0, y = 0;  // y from the bottom
  int channel = 0;   // 0 red, 1 green, 2 blue
};

struct Difference {
  double rmse = 0;                                        // sqrt(mean (x - r)^2)
  double relative_mse = 0;                                // mean (x - r)^2 / (r^2 + 0.01)
  double display_rmse = 0;                                // the RMSE of the displayed values, in 255ths
  double psnr = std::numeric_limits<double>::infinity();  // of the displayed values: -10 log10(mean square), in dB
  Color bias;                                             // mean of x - r
  LargestDifference largest;                              // the first one in row order, from the bottom
  std::int64_t pixels = 0;
  std::int64_t pixels_not_finite = 0;  // in x or in r
};

/// Compares x with r. If no pixel is finite in both, all results except the counts are NaN.
Difference Compare(const Image& x, const Image& r, Display display);

/// Returns the squared error of x without the noise of its reference: mean (x - r1)(x - r2), with two references of the
/// same scene whose noise is independent. With r1 = m + n1 and r2 = m + n2 its expectation is mean (x - m)^2, whereas
/// mean (x - r1)^2 is too large by the variance of r1. May be negative if the error is smaller than the noise.
///   source  what a noisy reference does to reported errors: Whittle, Jones, Mantiuk, Analysis of Reported Error in
///           Monte Carlo Rendered Images (2017)
double ProductMse(const Image& x, const Image& r1, const Image& r2);

/// Returns the number of pixels with a channel that is not finite or has |x - r| above the threshold.
std::int64_t PixelsBeyond(const Image& x, const Image& r, double threshold);

/// Returns the largest difference of a displayed channel, 0 to 1, for each pixel.
Plane DisplayDifference(const Image& x, const Image& r, Display display);

/// Returns an image of the differences: black where equal, red where x is brighter, blue where it is darker, and pink
/// where channels disagree. Its brightness is four times the largest difference of a channel.
Image SignedDifference(const Image& x, const Image& r);

}  // namespace R2
