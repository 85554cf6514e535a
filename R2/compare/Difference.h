#pragma once

#include <cstdint>
#include <limits>

#include "R2/Image.h"
#include "R2/Plane.h"

/// How far a picture x is from a reference r of the same size (asserted). Means are over all channels of all pixels
/// that are finite in every picture compared; the others are counted, never averaged in.
namespace R2 {

/// How the values of a picture become those that a screen is given.
enum class Display {
  straight,  // clamped to [0, 1]
  srgb,      // clamped to [0, 1], then encoded with the sRGB curve
};

/// NaN is shown as black, as it is in files of bytes.
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
  LargestDifference largest;                              // the first one in order of rows, from the bottom
  std::int64_t pixels = 0;
  std::int64_t pixels_not_finite = 0;  // in x or in r
};

/// All NaN, but for the counts, when no pixel is finite in both.
Difference Compare(const Image& x, const Image& r, Display display);

/// The squared error of x without the noise of its reference: mean (x - r1)(x - r2), with two references of the same
/// picture whose noise is independent. With r1 = m + n1 and r2 = m + n2 its expectation is mean (x - m)^2, where
/// mean (x - r1)^2 is too large by the variance of r1. It may come out negative when there is less error than noise.
///   source  what a noisy reference does to reported errors: Whittle, Jones, Mantiuk, Analysis of Reported Error in
///           Monte Carlo Rendered Images (2017)
double ProductMse(const Image& x, const Image& r1, const Image& r2);

/// How many pixels have a channel with |x - r| above the threshold, or one that is not finite.
std::int64_t PixelsBeyond(const Image& x, const Image& r, double threshold);

/// The largest difference of a displayed channel, 0 to 1, pixel by pixel.
Plane DisplayDifference(const Image& x, const Image& r, Display display);

/// Black where equal; brighter where x is brighter, in red, or darker, in blue; pink where channels disagree. Four
/// times as bright as the largest difference of a channel.
Image SignedDifference(const Image& x, const Image& r);

}  // namespace R2
