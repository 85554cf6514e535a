#include "source/render/forecast/FinishForecast.h"

#include <algorithm>
#include <span>
#include <vector>

#include "source/film/PixelRectangle.h"
#include "source/render/forecast/DenoiseForecast.h"
#include "source/render/forecast/SecondsOf.h"

namespace ray {
namespace {

// Squares of this many pixels on a side are examined: few, and a small part of the image.
constexpr int side_of_part = 128, most_parts = 8;
constexpr double most_looked_at = 1.0 / 32;
// The additional seconds per pixel of images of 4 to 67 million pixels, compared with their parts, as PNG and as JPEG:
// for memory that the system must allocate and that exceeds caches.
constexpr double seconds_of_memory = 10e-9;

/// Stacks the parts' images, so that the fixed cost of a file counts once.
R2::Image Stacked(std::span<const Film> parts, R2::Quantization quantization) {
  const int width = parts[0].Region().Width(), height = parts[0].Region().Height();
  R2::Image stack(width, height * static_cast<int>(parts.size()));
  int row = 0;
  for (const Film& part : parts) {
    const R2::Image image = part.Image(quantization);
    for (int y = 0; y < height; ++y, ++row)
      for (int x = 0; x < width; ++x) stack.Set(x, row, image.At(x, y));
  }
  return stack;
}

/// Returns an image that resembles one of few samples after the pixels between them are filled.
R2::Image Slope(int side) {
  R2::Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double level = static_cast<double>(x + y) / (2 * side);
      image.Set(x, y, {level, level / 2, 1 - level});
    }
  return image;
}

}  // namespace

double SecondsToFinish(const RenderSettings& settings, const std::function<void(const R2::Image&)>& encode) {
  // Images of 16 and 67 million pixels, a 64th of which had a sample, took this long on two threads.
  constexpr double seconds_to_compose_a_pixel = 20e-9, price_beside_slope = 1.2;
  constexpr int side = 128, attempts = 4;
  const R2::Image slope = Slope(side);
  const double seconds = LeastSecondsOf(attempts, [&] { encode(slope); });
  return static_cast<double>(RegionOf(settings).Area()) *
         (price_beside_slope * seconds / (side * side) + seconds_to_compose_a_pixel);
}

Budget BudgetWithFinish(const RenderSettings& settings, const std::function<void(const R2::Image&)>& encode) {
  Budget budget = settings.budget;
  if (budget.seconds == 0) return budget;
  budget.seconds_to_finish = SecondsToFinish(settings, encode);
  if (settings.denoise) budget.seconds_to_filter = SecondsToFilter(settings);
  return budget;
}

void FinishForecast::Look(const Film& film, R2::Quantization quantization) {
  if (!encode_) return;
  const auto pixels = static_cast<double>(film.Region().Area());
  const int count =
      std::clamp(static_cast<int>(most_looked_at * pixels / (side_of_part * side_of_part)), 1, most_parts);
  std::vector<Film> parts;
  for (int i = 0; i < count; ++i)
    parts.push_back(film.Cut(SpreadRectangle(film.Region(), side_of_part, side_of_part, i)));
  const auto pixels_seen = static_cast<double>(count * parts[0].Region().Area());
  const double seconds = LeastSecondsOf(2, [&] { encode_(Stacked(parts, quantization)); });
  const double foretold = (seconds / pixels_seen + seconds_of_memory) * pixels;
  seconds_ = has_looked_ ? (seconds_ + foretold) / 2 : foretold;  // measurements vary with the machine's load
  has_looked_ = true;
}

}  // namespace ray
