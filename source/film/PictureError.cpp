#include "source/film/PictureError.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

namespace ray {
namespace {

using Channels = std::array<double, 3>;

/// A channel as the measure looks at it.
double Seen(double x, const ErrorMeasure& measure) {
  if (measure.unit == ErrorUnit::relative || measure.unit == ErrorUnit::linear) return x;
  const double shown = std::clamp(x, 0.0, 1.0);
  return measure.srgb ? R2::EncodeSrgb(shown) : shown;
}

Channels Seen(const R2::Color& c, const ErrorMeasure& measure) {
  return {Seen(c.r, measure), Seen(c.g, measure), Seen(c.b, measure)};
}

double InUnit(double mean_square, const ErrorMeasure& measure, double mean) {
  const double root = std::sqrt(std::max(0.0, mean_square));
  switch (measure.unit) {
    case ErrorUnit::display:
      return 255 * root;
    case ErrorUnit::relative:
      return mean > 0 ? 100 * root / mean : root > 0 ? std::numeric_limits<double>::infinity() : 0;
    case ErrorUnit::decibel:
      return -20 * std::log10(root);
    case ErrorUnit::linear:
      return root;
  }
  return root;
}

struct PixelErrors {
  std::vector<float> squares;  // of the region's pixels, the mean of their channels
  R2::Image picture;
};

PixelErrors SquaredErrors(const Film& film, const ErrorMeasure& measure) {
  const R2::Image a = film.Part(0), b = film.Part(1);
  const PixelRectangle& region = film.Region();
  PixelErrors errors{std::vector<float>(static_cast<std::size_t>(region.Area())), film.Picture()};
  tbb::parallel_for(region.y0, region.y1, [&](int y) {
    float* square = &errors.squares[static_cast<std::size_t>(y - region.y0) * static_cast<std::size_t>(region.Width())];
    for (int x = region.x0; x < region.x1; ++x) {
      const double share = film.ShareOfDifference(x, y);
      const Channels ca = Seen(a.At(x - region.x0, y - region.y0), measure);
      const Channels cb = Seen(b.At(x - region.x0, y - region.y0), measure);
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += (ca[k] - cb[k]) * (ca[k] - cb[k]);
      *square++ = static_cast<float>(share * sum / 3);
    }
  });
  return errors;
}

std::vector<double> MeansOfBlocks(const Film& film, const std::vector<float>& squares) {
  const PixelRectangle& region = film.Region();
  std::vector<double> means(static_cast<std::size_t>(film.Blocks()));
  std::vector<int> counts(means.size());
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) {
      const auto block = static_cast<std::size_t>(film.BlockOf(x, y));
      means[block] += squares[static_cast<std::size_t>(y - region.y0) * static_cast<std::size_t>(region.Width()) +
                              static_cast<std::size_t>(x - region.x0)];
      ++counts[block];
    }
  for (std::size_t i = 0; i < means.size(); ++i)
    if (counts[i] > 0) means[i] /= counts[i];
  return means;
}

double NormalQuantile(double p) {
  double low = 0, high = 40;
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2;
    (0.5 * std::erfc(-middle / std::numbers::sqrt2) < p ? low : high) = middle;
  }
  return (low + high) / 2;
}

struct Interval {
  double mean, low, high;
};

/// The mean square of the pixels, from that of blocks, which at the rim of the picture may be narrower: each counts by
/// its area.
Interval MeanSquare(const std::vector<double>& blocks, const std::vector<double>& areas, double confidence) {
  double total = 0, pixels = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    total += blocks[i] * areas[i];
    pixels += areas[i];
  }
  const double mean = total / pixels;
  double variance = 0, third_moment = 0, blocks_with_area = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const double share = areas[i] / pixels;
    const double away = share * (blocks[i] - mean);
    variance += away * away;
    third_moment += away * away * away;
    if (areas[i] > 0) ++blocks_with_area;
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double freedom = blocks_with_area - 1;
  if (freedom < 1) return {mean, -infinity, infinity};
  const double t = StudentQuantile((1 + confidence) / 2, freedom);
  const double deviation = std::sqrt(variance * blocks_with_area / freedom);
  const double skewness = variance > 0 ? third_moment / (variance * std::sqrt(variance)) : 0;
  // Of few blocks the skewness is hardly known: it may widen the interval upwards, by no more than it was, and does not
  // narrow it downwards.
  const double shift = std::clamp(skewness * (1 + 2 * t * t) / 6, 0.0, t);
  return {mean, mean - deviation * t, mean + deviation * (t + shift)};
}

/// How much of the sum of all squares is in the largest thousandth of them.
double OutlierShare(const std::vector<float>& squares) {
  std::vector<float> sorted = squares;
  const auto outliers_end = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() + 999) / 1000);
  std::nth_element(sorted.begin(), outliers_end - 1, sorted.end(), std::greater<>());
  const double in_all = std::accumulate(squares.begin(), squares.end(), 0.0);
  const double in_outliers = std::accumulate(sorted.begin(), outliers_end, 0.0);
  return in_all > 0 ? in_outliers / in_all : 0;
}

}  // namespace

const char* ErrorUnitName(ErrorUnit unit) {
  switch (unit) {
    case ErrorUnit::display:
      return "255ths";
    case ErrorUnit::relative:
      return "%";
    case ErrorUnit::decibel:
      return "dB";
    case ErrorUnit::linear:
      return "lin";
  }
  return "";
}

std::string ErrorText(double error, ErrorUnit unit) {
  std::array<char, 64> text{};
  const auto [end, fault] = std::to_chars(text.data(), text.data() + text.size(), error, std::chars_format::general, 3);
  return std::string(text.data(), end) + (unit == ErrorUnit::display ? "/255" : std::string(" ") + ErrorUnitName(unit));
}

double MeanOf(const R2::Image& picture) {
  double sum = 0;
  for (const float channel : picture.Channels()) sum += channel;
  return picture.Channels().empty() ? 0 : sum / static_cast<double>(picture.Channels().size());
}

double SquaredTarget(double target, const ErrorMeasure& measure, double mean) {
  switch (measure.unit) {
    case ErrorUnit::display:
      return target / 255 * target / 255;
    case ErrorUnit::relative:
      return target * mean / 100 * (target * mean / 100);
    case ErrorUnit::decibel:
      return std::pow(10, -target / 10);
    case ErrorUnit::linear:
      return target * target;
  }
  return 0;
}

std::optional<MeasuredError> MeasureError(const Film& film, const ErrorMeasure& measure) {
  if (!film.HasBothParts()) return {};
  const PixelErrors errors = SquaredErrors(film, measure);
  const double mean_of_picture = MeanOf(errors.picture);
  std::vector<double> blocks = MeansOfBlocks(film, errors.squares);
  std::vector<double> areas(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    areas[i] = static_cast<double>(film.PixelsInRegion(static_cast<int>(i)).Area());
  const Interval square = MeanSquare(blocks, areas, measure.confidence);
  std::size_t worst = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (areas[i] > 0 && blocks[i] > blocks[worst]) worst = i;

  ErrorEstimate e;
  e.unit = measure.unit;
  e.estimate = InUnit(square.mean, measure, mean_of_picture);
  e.low = InUnit(square.low, measure, mean_of_picture);
  e.high = InUnit(square.high, measure, mean_of_picture);
  e.worst_block = InUnit(blocks[worst], measure, mean_of_picture);
  e.worst_block_at = film.PixelsInRegion(static_cast<int>(worst));
  e.outlier_share = OutlierShare(errors.squares);
  return MeasuredError{e, square.mean, square.high, mean_of_picture, std::move(blocks)};
}

double TrueError(const R2::Image& picture, const R2::Image& reference, const R2::Image* second,
                 const ErrorMeasure& measure) {
  double sum = 0;
  for (int y = 0; y < picture.Height(); ++y)
    for (int x = 0; x < picture.Width(); ++x) {
      const Channels c = Seen(picture.At(x, y), measure), r = Seen(reference.At(x, y), measure);
      const Channels s = second ? Seen(second->At(x, y), measure) : r;
      for (std::size_t k = 0; k < 3; ++k) sum += (c[k] - r[k]) * (c[k] - s[k]);
    }
  return InUnit(sum / (3.0 * picture.Width() * picture.Height()), measure, MeanOf(reference));
}

double StudentQuantile(double p, double n) {
  if (n <= 1) return std::tan(std::numbers::pi * (p - 0.5));
  if (n <= 2) return (2 * p - 1) / std::sqrt(2 * p * (1 - p));
  const double z = NormalQuantile(p), z2 = z * z;
  const double g1 = (z2 + 1) * z / 4;
  const double g2 = ((5 * z2 + 16) * z2 + 3) * z / 96;
  const double g3 = (((3 * z2 + 19) * z2 + 17) * z2 - 15) * z / 384;
  const double g4 = ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) * z / 92160;
  return z + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n;
}

}  // namespace ray
