#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "R2/Image.h"
#include "source/film/Film.h"

namespace ray {

/// How the error of a picture is counted; all are roots of a mean over pixels and channels.
///   display    of the values a screen shows, clamped to 0..1 (and sRGB encoded where the picture is), in 255ths
///   relative   of the light itself, in hundredths of its mean over the picture
///   decibel    display, as peak signal to noise ratio: 20 log10(255 / display); MORE is better
///   linear     of the light itself, in the scene's units
enum class ErrorUnit { display, relative, decibel, linear };

/// Rather than of what a screen shows, which is clamped.
constexpr bool IsOfLight(ErrorUnit unit) { return unit == ErrorUnit::relative || unit == ErrorUnit::linear; }

/// "1.25/255", "3.1%", "42 dB", "0.002 lin".
std::string ErrorText(double error, ErrorUnit unit);
/// In reports: "255ths", "%", "dB", "lin".
const char* ErrorUnitName(ErrorUnit unit);

/// A root mean square error as far as samples can tell, in its unit.
struct ErrorEstimate {
  ErrorUnit unit = ErrorUnit::display;
  double estimate = 0;
  double low = 0, high = 0;  // where the truth is with the confidence asked for; low is the better end in any unit
  double worst_block = 0;    // the largest error of a block of 8x8 pixels
  PixelRectangle worst_block_at;
  double outlier_share = 0;  // of the squared error, in the worst thousandth of the pixels
  // Degrees of freedom that the error's square has as a mean of squares: how many independent values of pixels hold it.
  // Where they are few, the true error of another picture of the same kind is another one.
  double freedom = 0;

  double unseen_share = 0;  // of the square of `high`, for light that no sample has found, see UnseenLight

  bool IsMostlyOutliers() const { return outlier_share > 0.5; }
  bool IsMostlyUnseen() const { return unseen_share > 0.5; }

  /// Calls visit with each field of an estimate, const or not, in the order of files.
  template <class Estimate, class Visit>
  static void ForEachField(Estimate& e, const Visit& visit) {
    visit(e.unit), visit(e.estimate), visit(e.low), visit(e.high), visit(e.worst_block), visit(e.worst_block_at);
    visit(e.outlier_share), visit(e.unseen_share), visit(e.freedom);
  }
};

/// How errors are counted: the unit, the confidence of the interval in (0, 1), and whether the picture is sRGB encoded.
struct ErrorMeasure {
  ErrorUnit unit = ErrorUnit::display;
  double confidence = 0.95;
  bool srgb = false;
  double share = 1;  // of the image's pixels that the film has; its errors, and their number, stand for all of them
};

/// The squared errors of a film's blocks at one time, to tell by how they fell.
struct BlockErrors {
  std::vector<double> squares;         // means over their pixels, 0 outside the region
  std::vector<std::uint32_t> samples;  // per pixel

  bool IsEmpty() const { return squares.empty(); }
};

/// An error estimate and what it was made from. Squares are of display values in 0..1, or of light.
struct MeasuredError {
  ErrorEstimate estimate;
  double square = 0, square_high = 0;    // of the estimate and of the worse end of its interval
  double mean = 0;                       // of the picture
  std::vector<double> square_of_blocks;  // in the order of the film's blocks; 0 outside the region
  BlockErrors differences;               // what the next estimate can be compared with
};

/// The error of the film's picture, from the difference of its two parts: true on average where they are independent,
/// at most about true where they are the first and the last samples of one well distributed sequence. Nothing while a
/// block lacks a part.
///
/// In linear light, the squared error of the mean of both parts is a quarter of their squared difference. What a screen
/// shows is clamped, and three things are added: the bias of clamping, which is what the parts' mean shown differs from
/// the mean of the parts shown (the jackknife; Quenouille, Notes on bias in estimation, 1956); that the error may not
/// fall as the root of the samples, by how it fell since `before`, at most to a quarter of that; and where clamping
/// took energy from noisy pixels, that it belongs to others of their block, as far as these can show it. The larger of
/// the last two counts. What the error of a block was before counts as far as more samples cannot explain that it fell.
///
/// The interval is that of the ratio of two mean squares, the claim and the truth, of two thirds as many degrees of
/// freedom or fewer: where few pixels hold the error, both are from few.
///   before   the differences at fewer samples; null or empty where none were measured
std::optional<MeasuredError> MeasureError(const Film& film, const ErrorMeasure& measure,
                                          const BlockErrors* before = nullptr);

/// The error that a picture of the film's region has by the squared errors of its pixels, in rows from the bottom, each
/// the mean of their channels and true on average; single ones may be negative. The interval is as above.
MeasuredError SummarizeErrors(const Film& film, const std::vector<float>& squares, const R2::Image& picture,
                              const ErrorMeasure& measure);

/// Light that may be there though none of the picture's samples found any.
struct UnseenLight {
  double most = 0;     // that it brings to a sample, and so to a pixel, in the scene's units; 0: there is none
  double samples = 0;  // of the picture
};

/// Widens an interval for such light: with the confidence of the interval, at most -ln((1 - confidence) / 2) / samples
/// of all samples find it (the rule of three; Hanley, Lippman-Hand, If nothing goes wrong, is everything all right?,
/// 1983), wherever in the picture that is.
void AllowFor(const UnseenLight& unseen, const ErrorMeasure& measure, MeasuredError& error);

/// A channel as the measure looks at it.
double AsMeasured(double channel, const ErrorMeasure& measure);

/// What the mean square is at an error of `target` in the unit of `measure`. `mean` is of the picture.
double SquaredTarget(double target, const ErrorMeasure& measure, double mean);
/// Mean over all channels of all pixels.
double MeanOf(const R2::Image& picture);

/// The error of a picture beside a reference of the same size. With a second reference, independent of the first, the
/// noise of both cancels on average:
///   source   mean((x - r1)(x - r2)); the estimate may be negative below the references' noise and then is 0
double TrueError(const R2::Image& picture, const R2::Image& reference, const R2::Image* second,
                 const ErrorMeasure& measure);

}  // namespace ray
