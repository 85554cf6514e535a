#include "source/app/files/FinishingTime.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "source/sample/Random.h"

namespace ray {
namespace {

constexpr int side = 128;  // of images that are encoded to see how long that takes

/// What compresses worst.
R2::Image Noise() {
  R2::Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const RandomKey key = RandomKey(0).Child(static_cast<std::uint64_t>(y * side + x));
      image.Set(x, y, {key.Child(0).Number(), key.Child(1).Number(), key.Child(2).Number()});
    }
  return image;
}

/// What is left of a picture of few samples, once the pixels between them are filled.
R2::Image Slope() {
  R2::Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double level = static_cast<double>(x + y) / (2 * side);
      image.Set(x, y, {level, level / 2, 1 - level});
    }
  return image;
}

/// The least of several: the first makes what is made once only, and others may have to wait for a processor.
double SecondsToEncodeAPixel(const R2::ImageFormat& format, const R2::ImageEncoding& encoding, const R2::Image& image) {
  constexpr int attempts = 4;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < attempts; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    format.encode(image, encoding, {});
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return least / (side * side);
}

}  // namespace

FinishingTime FinishingTimeOf(const R2::ImageFormat& format, const Options& options) {
  constexpr double seconds_to_compose_a_pixel = 30e-9;  // by all threads; 42 beside as much other work
  const RenderSettings& render = options.render;
  const double pixels = render.crop ? static_cast<double>(render.crop->Area())
                                    : static_cast<double>(render.width) * static_cast<double>(render.height);
  const auto seconds = [&](const R2::Image& image) {
    return pixels * (SecondsToEncodeAPixel(format, options.encoding, image) + seconds_to_compose_a_pixel);
  };
  return {seconds(Slope()), seconds(Noise())};
}

}  // namespace ray
