#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "R2/Image.h"
#include "source/film/error/FQuantile.h"
#include "tests/ChiSquare.h"
#include "tests/Project.h"

/// Whether noisy pictures have the mean they should have.
namespace statistics {

/// What a picture's storage rounds away: floats have 24 bits.
inline constexpr double rounding_of_floats = 0x1p-24;

/// A mean of independent numbers and its standard deviation.
struct Mean {
  double mean = 0, deviation = 0;

  friend Mean operator*(double s, const Mean& m) { return {s * m.mean, s * m.deviation}; }
};

inline Mean MeanOf(const std::vector<double>& numbers) {
  const auto n = static_cast<double>(numbers.size());
  double sum = 0, squares = 0;
  for (const double x : numbers) sum += x;
  for (const double x : numbers) squares += (x - sum / n) * (x - sum / n);
  return {sum / n, std::sqrt(squares / (n - 1) / n)};
}

/// The mean luminance of pixels that all show the same and are sampled independently.
inline Mean MeanOverPixels(const R2::Image& image) {
  std::vector<double> pixels;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) pixels.push_back(Luminance(image.At(x, y)));
  return MeanOf(pixels);
}

/// How many standard deviations a mean is off the truth, which itself is known within a share of it.
inline double Deviations(const Mean& m, double truth, double known_within) {
  return (m.mean - truth) / std::hypot(m.deviation, known_within * truth);
}

/// Pictures of one scene under one setting with seeds of their own.
inline std::vector<R2::Image> Pictures(const project::Stage& stage, ray::RenderSettings settings, int count,
                                       std::uint64_t first_seed) {
  std::vector<R2::Image> pictures;
  for (int i = 0; i < count; ++i) {
    settings.seed = first_seed + static_cast<std::uint64_t>(i);
    pictures.push_back(project::Render(stage, settings).image);
  }
  return pictures;
}

/// How two sets of pictures that should have the same mean differ.
struct Comparison {
  double worst_pixel = 0;  // Welch's t over what it exceeds with probability 0.01 in any pixel of equal pictures
  double whole = 0;        // the difference of the means over all pixels, in its standard deviations
  double deviation = 0;    // of that difference, as a share of the mean: what the comparison could see
};

/// Source: Welch, The generalization of Student's problem when several different population variances are involved
/// (1947); corrected for the number of pixels after Bonferroni.
inline Comparison Compare(const std::vector<R2::Image>& a, const std::vector<R2::Image>& b) {
  const int width = a[0].Width(), height = a[0].Height();
  const auto n = static_cast<double>(std::min(a.size(), b.size()));
  const double limit = std::sqrt(ray::FQuantile(1 - 0.01 / (1.0 * width * height), 1, n - 1));  // of Student's t
  const auto mean_of = [](const std::vector<R2::Image>& pictures, const auto& number_of) {
    std::vector<double> numbers;
    for (const R2::Image& picture : pictures) numbers.push_back(number_of(picture));
    return MeanOf(numbers);
  };
  Comparison c;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto pixel = [&](const R2::Image& picture) { return Luminance(picture.At(x, y)); };
      const Mean one = mean_of(a, pixel), other = mean_of(b, pixel);
      const double rounding = 8 * rounding_of_floats * one.mean;
      const double spread = std::hypot(std::hypot(one.deviation, other.deviation), rounding);
      if (spread > 0) c.worst_pixel = std::max(c.worst_pixel, std::abs(one.mean - other.mean) / spread / limit);
    }
  const auto whole = [](const R2::Image& picture) { return MeanOverPixels(picture).mean; };
  const Mean one = mean_of(a, whole), other = mean_of(b, whole);
  const double spread = std::hypot(std::hypot(one.deviation, other.deviation), 8 * rounding_of_floats * one.mean);
  c.whole = (one.mean - other.mean) / spread;
  c.deviation = spread / one.mean;
  return c;
}

/// The slope of log error over log count.
inline double Slope(const std::vector<double>& counts, const std::vector<double>& errors) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double log_x = std::log(counts[i]), log_y = std::log(errors[i]);
    x += log_x / n, y += log_y / n, xx += log_x * log_x / n, xy += log_x * log_y / n;
  }
  return (xy - x * y) / (xx - x * x);
}

}  // namespace statistics
