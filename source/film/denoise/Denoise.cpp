#include "source/film/denoise/Denoise.h"

#include <tbb/parallel_for.h>

#include <cassert>
#include <cmath>
#include <cstdint>

#include "R1/Elementary.h"
#include "source/film/denoise/Denoiser.h"
#include "source/film/denoise/FitTile.h"
#include "source/film/denoise/LocalFit.h"

namespace ray {
namespace {

/// One image for each stream.
using Pair = std::array<Pixels<Rgb>, 2>;

// Noise is averaged over noise_radius pixels around each pixel. The hole keeps a pixel's own noise from making its
// neighbors look similar to it. Both must be at least a patch.
constexpr int noise_radius = 3, noise_hole = 1;
// Filters are chosen by their errors around a pixel, and blended by the choices up to blend_radius pixels around it.
// The hole, which is larger, keeps a pixel's own noise from influencing these choices.
constexpr int error_radius = 7, error_hole = 3, blend_radius = 2;
static_assert(blend_radius < error_hole);
static_assert(denoise_reach_of_best_guides == blend_radius + error_radius);
static_assert(denoise_reach == denoise_reach_of_best_guides + FitTile::margin + noise_radius);

/// A regression among which pixels choose. Of strengths from 0.5 to 6, with a guide ignored or not, these two had the
/// least error of all pairs; a third filter had 3% less error in one and a half times the time.
struct RegressionFilter {
  double strength;
  // compares pixels by their color minus the first guide, which is the expected color
  bool ignores_guide;
};
constexpr RegressionFilter regression_filters[] = {{1, false}, {2, true}};

/// Returns the scale in which differences of light are measured: linear up to the maximum of a screen, logarithmic
/// above, so that a single bright sample does not decide alone.
float Compressed(float x) {
  const float size = std::abs(x);
  return size <= 1 ? x : std::copysign(1 + static_cast<float>(R1::Log(size)), x);
}

/// Computes an image in parallel; of_channel(x, y, k) returns a channel.
template <typename OfChannel>
Pixels<Rgb> Made(int width, int height, const OfChannel& of_channel) {
  Pixels<Rgb> pixels(width, height);
  tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x)
      for (std::size_t k = 0; k < 3; ++k) pixels.At(x, y)[k] = of_channel(x, y, k);
  });
  return pixels;
}

/// Returns the mean variance of one stream's noise: half the squared difference of both streams, averaged.
Pixels<Rgb> NoiseOf(const Pair& pair) {
  const Pixels<Rgb> squares = Made(pair[0].Width(), pair[0].Height(), [&](int x, int y, std::size_t k) {
    const float difference = pair[0].At(x, y)[k] - pair[1].At(x, y)[k];
    return difference * difference / 2;
  });
  const Pixels<Rgb> means = MeansAround(squares, noise_radius, noise_hole);
  return Made(means.Width(), means.Height(),
              [&](int x, int y, std::size_t k) { return std::max(0.0F, means.At(x, y)[k]); });
}

Pair Filtered(const Pair& colors, const Guides& guides, const RegressionFilter& filter, WorkMeter& meter) {
  Pair compared, result;
  for (std::size_t i = 0; i < 2; ++i)
    compared[i] = Made(colors[i].Width(), colors[i].Height(), [&](int x, int y, std::size_t k) {
      const float expected = filter.ignores_guide ? Compressed(guides.of_stream[i].At(x, y)[k]) : 0;
      return Compressed(colors[i].At(x, y)[k]) - expected;
    });
  const Pixels<Rgb> noise = NoiseOf(compared);
  for (std::size_t i = 0; i < 2; ++i)
    result[i] = LocalFit({colors[i], guides.of_stream[i], guides.best[i], compared[i], noise, filter.strength}, meter);
  return result;
}

/// Returns the squared error of the mean of two filtered streams, per channel, unbiased. With F, G the filtered and A,
/// B the unfiltered streams, ((F - B)^2 + (G - A)^2) / 2 exceeds the mean squared error of F and of G by the variance
/// of A or B, which is (A - B)^2 / 2. The error of the mean of F and G is less than theirs by (F - G)^2 / 4.
Pixels<Rgb> SquaredErrors(const Pair& filtered, const Pair& colors) {
  return Made(colors[0].Width(), colors[0].Height(), [&](int x, int y, std::size_t k) {
    const float a = Compressed(colors[0].At(x, y)[k]), b = Compressed(colors[1].At(x, y)[k]);
    const float f = Compressed(filtered[0].At(x, y)[k]), g = Compressed(filtered[1].At(x, y)[k]);
    return ((f - b) * (f - b) + (g - a) * (g - a)) / 2 - (a - b) * (a - b) / 2 - (f - g) * (f - g) / 4;
  });
}

Pair FilteredBy(const OpenImageDenoise& library, const Pair& colors, const Guides& guides) {
  return {library.Filtered(colors[0], guides.best[0]), library.Filtered(colors[1], guides.best[1])};
}

/// The number of times that each candidate is chosen among some pixels, in one byte each.
using Counts = std::uint32_t;
constexpr std::size_t most_candidates = sizeof(Counts);
constexpr int most_choices = (2 * blend_radius + 1) * (2 * blend_radius + 1);
static_assert(most_choices < 256);

std::uint32_t CountOf(Counts counts, std::size_t candidate) { return counts >> 8 * candidate & 255; }

/// Returns a choice for each pixel: the candidate with the least error, or the first of several.
Pixels<Counts> Choices(const std::vector<Pair>& candidates) {
  const Pair& colors = candidates.front();
  std::vector<Pixels<Rgb>> errors;
  for (const Pair& candidate : candidates)
    errors.push_back(MeansAround(SquaredErrors(candidate, colors), error_radius, error_hole));
  Pixels<Counts> choices(colors[0].Width(), colors[0].Height());
  tbb::parallel_for(0, choices.Height(), [&](int y) {
    for (int x = 0; x < choices.Width(); ++x) {
      const auto error_of = [&](std::size_t i) {
        const Rgb& error = errors[i].At(x, y);
        return error[0] + error[1] + error[2];
      };
      std::size_t choice = 0;
      for (std::size_t i = 1; i < candidates.size(); ++i)
        if (error_of(i) < error_of(choice)) choice = i;
      choices.At(x, y) = Counts{1} << 8 * choice;
    }
  });
  return choices;
}

/// Counts the choices at most blend_radius columns and rows away from each pixel.
Pixels<Counts> CountsAround(const Pixels<Counts>& choices) {
  const int width = choices.Width(), height = choices.Height();
  Pixels<Counts> counts(width, height);
  tbb::parallel_for(0, height, [&](int y) {
    std::vector<Counts> columns(static_cast<std::size_t>(width));
    for (int j = std::max(0, y - blend_radius); j <= std::min(height - 1, y + blend_radius); ++j)
      for (int x = 0; x < width; ++x) columns[static_cast<std::size_t>(x)] += choices.At(x, j);
    for (int x = 0; x < width; ++x)
      for (int i = std::max(0, x - blend_radius); i <= std::min(width - 1, x + blend_radius); ++i)
        counts.At(x, y) += columns[static_cast<std::size_t>(i)];
  });
  return counts;
}

/// Blends the candidates at each pixel in proportion to the choices around it.
Pixels<Rgb> Blended(const std::vector<Pair>& candidates, const Pixels<Counts>& counts, std::size_t stream) {
  Pixels<Rgb> blended(counts.Width(), counts.Height());
  tbb::parallel_for(0, counts.Height(), [&](int y) {
    for (int x = 0; x < counts.Width(); ++x) {
      std::array<double, 3> sum{};
      double count = 0;
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const double share = CountOf(counts.At(x, y), i);
        for (std::size_t k = 0; k < 3; ++k) sum[k] += share * candidates[i][stream].At(x, y)[k];
        count += share;
      }
      for (std::size_t k = 0; k < 3; ++k) blended.At(x, y)[k] = static_cast<float>(sum[k] / count);
    }
  });
  return blended;
}

}  // namespace

R2::Image DenoisedImage::Mean() const {
  const Pair pair{PixelsOf(of_stream[0]), PixelsOf(of_stream[1])};
  return ImageOf(Made(pair[0].Width(), pair[0].Height(),
                      [&](int x, int y, std::size_t k) { return pair[0].At(x, y)[k] / 2 + pair[1].At(x, y)[k] / 2; }));
}

DenoisedImage Denoise(const R2::Image& a, const R2::Image& b, const Guides& guides, const DenoiseFilters& filters,
                      WorkMeter& meter) {
  const Pair colors{PixelsOf(a), PixelsOf(b)};
  if (filters.HasRegression())
    meter.Expect(std::ssize(regression_filters) * std::ssize(colors) * LocalFitTiles(a.Width(), a.Height()));
  std::vector<Pair> candidates{colors};
  if (filters.HasRegression())
    for (const RegressionFilter& filter : regression_filters)
      candidates.push_back(Filtered(colors, guides, filter, meter));
  if (filters.Library()) candidates.push_back(FilteredBy(*filters.Library(), colors, guides));
  assert(candidates.size() <= most_candidates);
  const Pixels<Counts> counts = CountsAround(Choices(candidates));
  return {{ImageOf(Blended(candidates, counts, 0)), ImageOf(Blended(candidates, counts, 1))}};
}

DenoisedImage Denoise(const R2::Image& a, const R2::Image& b, const Guides& guides, const DenoiseFilters& filters) {
  WorkMeter nobody;
  return Denoise(a, b, guides, filters, nobody);
}

}  // namespace ray
