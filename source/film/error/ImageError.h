#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "R2/Image.h"
#include "source/film/Film.h"

namespace ray {

/// The measure of an image's error. Each is a root of a mean over pixels and channels.
///   display    of displayed values, clamped to 0..1 (and sRGB encoded if the image is), in 255ths
///   relative   of the light itself, in hundredths of its mean over the image
///   decibel    display, as peak signal to noise ratio: 20 log10(255 / display); MORE is better
///   linear     of the light itself, in the scene's units
enum class ErrorUnit { display, relative, decibel, linear };

/// Returns true for units of light, false for those of displayed values, which are clamped.
constexpr bool IsOfLight(ErrorUnit unit) { return unit == ErrorUnit::relative || unit == ErrorUnit::linear; }

/// Returns "1.25/255", "3.1%", "42 dB" or "0.002 lin".
std::string ErrorText(double error, ErrorUnit unit);
/// Returns the name of a unit in reports: "255ths", "%", "dB" or "lin".
const char* ErrorUnitName(ErrorUnit unit);

/// An estimate of a root mean square error, in its unit.
struct ErrorEstimate {
  ErrorUnit unit = ErrorUnit::display;
  double estimate = 0;
  double low = 0, high = 0;  // the confidence interval; low is the better end in any unit
  double worst_block = 0;    // the largest error of a block of 8x8 pixels
  PixelRectangle worst_block_at;
  double outlier_share = 0;  // share of the worst thousandth of the pixels in the squared error
  // The degrees of freedom of the squared error as a mean of squares: the number of independent pixel values in it. If
  // they are few, the true error of another image of the same kind differs.
  double freedom = 0;

  // share of light that no sample has found in the square of `high`, see UnseenLight
  double unseen_share = 0;

  bool IsMostlyOutliers() const { return outlier_share > 0.5; }
  bool IsMostlyUnseen() const { return unseen_share > 0.5; }

  /// Calls visit with each field of an estimate, const or not, in the order of files.
  template <class Estimate, class Visit>
  static void ForEachField(Estimate& e, const Visit& visit) {
    visit(e.unit), visit(e.estimate), visit(e.low), visit(e.high), visit(e.worst_block), visit(e.worst_block_at);
    visit(e.outlier_share), visit(e.unseen_share), visit(e.freedom);
  }
};

/// The way errors are measured: the unit, the confidence of the interval in (0, 1), and whether the image is sRGB
/// encoded.
struct ErrorMeasure {
  ErrorUnit unit = ErrorUnit::display;
  double confidence = 0.95;
  bool srgb = false;
  // share of the image's pixels that the film has; its errors, and their number, stand for all of them
  double share = 1;
};

/// The squared errors of a film's blocks at one time, for comparison with later ones.
struct BlockErrors {
  std::vector<double> squares;         // means over their pixels, 0 outside the region
  std::vector<std::uint32_t> samples;  // per pixel

  bool IsEmpty() const { return squares.empty(); }
};

/// An error estimate with its inputs. Squares are of display values in 0..1, or of light.
struct MeasuredError {
  ErrorEstimate estimate;
  double square = 0, square_high = 0;    // of the estimate and of the worse end of its interval
  double mean = 0;                       // of the image
  std::vector<double> square_of_blocks;  // in the order of the film's blocks; 0 outside the region
  BlockErrors differences;               // for comparison with the next estimate
};

/// Measures the error of the film's image, from the difference of its two parts. It is unbiased if they are
/// independent, and at most about true if they are the first and the last samples of one well distributed sequence.
/// Returns std::nullopt while a block lacks a part.
///
/// In linear light, the squared error of the mean of both parts is a quarter of their squared difference. Displayed
/// values are clamped, which adds:
///   - the bias of clamping: the difference of the displayed mean of the parts from the mean of the displayed parts
///   (the
///     jackknife; Quenouille, Notes on bias in estimation, 1956);
///   - a factor of up to 4 on the squared error if it has not fallen as 1 / samples since `before`;
///   - the energy that clamping took from noisy pixels, which may belong to others of their block, as far as these can
///     show it.
/// The larger of the last two counts. A block keeps an earlier error as far as more samples cannot explain that it
/// fell.
///
/// The interval is that of the ratio of two mean squares, the estimate and the truth, with two thirds of the degrees of
/// freedom or fewer: if few pixels contain the error, both come from few.
///   before   the differences at fewer samples; null or empty if none were measured
std::optional<MeasuredError> MeasureError(const Film& film, const ErrorMeasure& measure,
                                          const BlockErrors* before = nullptr);

/// Measures the error of an image of the film's region from the squared errors of its pixels, in rows from the bottom.
/// Each is the mean of the pixel's channels and unbiased; single ones may be negative. The interval is that of
/// MeasureError.
MeasuredError SummarizeErrors(const Film& film, const std::vector<float>& squares, const R2::Image& image,
                              const ErrorMeasure& measure);

/// Light that may exist though none of the image's samples found any.
struct UnseenLight {
  double most = 0;     // contribution to a sample, and so to a pixel, in the scene's units; 0: there is none
  double samples = 0;  // of the image
};

/// Widens an interval for unseen light. With the confidence of the interval, at most -ln((1 - confidence) / 2) /
/// samples of all samples find it, anywhere in the image (the rule of three; Hanley, Lippman-Hand, If nothing goes
/// wrong, is everything all right?, 1983).
void AllowFor(const UnseenLight& unseen, const ErrorMeasure& measure, MeasuredError& error);

/// Returns a channel as the measure counts it: displayed or linear.
double AsMeasured(double channel, const ErrorMeasure& measure);

/// Returns the mean square that corresponds to an error of `target` in the unit of `measure`. `mean` is that of the
/// image.
double SquaredTarget(double target, const ErrorMeasure& measure, double mean);
/// Returns the mean over all channels of all pixels.
double MeanOf(const R2::Image& image);

/// Returns the error of an image compared with a reference of the same size. With a second reference, independent of
/// the first, the noise of both cancels on average:
///   source   mean((x - r1)(x - r2)); the estimate may be negative below the references' noise and then is 0
double TrueError(const R2::Image& image, const R2::Image& reference, const R2::Image* second,
                 const ErrorMeasure& measure);

}  // namespace ray
