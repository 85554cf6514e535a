#include "source/app/files/FinishingTime.h"

#include <chrono>

#include "source/sample/Random.h"

namespace ray {
namespace {

/// What compresses worst.
R2::Image Noise(int side) {
  R2::Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const RandomKey key = RandomKey(0).Child(static_cast<std::uint64_t>(y * side + x));
      image.Set(x, y, {key.Child(0).Number(), key.Child(1).Number(), key.Child(2).Number()});
    }
  return image;
}

}  // namespace

double SecondsToFinish(const R2::ImageFormat& format, const Options& options) {
  constexpr int side = 128;
  constexpr double seconds_to_compose_a_pixel = 30e-9;  // by all threads; 42 beside as much other work
  const R2::Image noise = Noise(side);
  format.encode(noise, options.encoding, {});  // once for whatever is made at the first time only
  const auto begin = std::chrono::steady_clock::now();
  format.encode(noise, options.encoding, {});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const RenderSettings& render = options.render;
  const double pixels = render.crop ? static_cast<double>(render.crop->Area())
                                    : static_cast<double>(render.width) * static_cast<double>(render.height);
  return pixels * (seconds.count() / (side * side) + seconds_to_compose_a_pixel);
}

}  // namespace ray
