#include "source/app/files/FinishingTime.h"

#include "source/app/options/PictureName.h"
#include "source/render/forecast/DenoiseForecast.h"
#include "source/render/forecast/SecondsOf.h"

namespace ray {
namespace {

constexpr int side = 128;  // of the image that is encoded to see how long that takes

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

double SecondsToEncodeAPixel(const R2::ImageFormat& format, const R2::ImageEncoding& encoding, const R2::Image& image) {
  constexpr int attempts = 4;
  return LeastSecondsOf(attempts, [&] { format.encode(image, encoding, {}); }) / (side * side);
}

}  // namespace

double FinishingTimeOf(const R2::ImageFormat& format, const Options& options) {
  // Of pictures of 16 and 67 million pixels, a 64th of which had a sample, on two threads.
  constexpr double seconds_to_compose_a_pixel = 20e-9, price_beside_slope = 1.2;
  const RenderSettings& render = options.render;
  const double pixels = render.crop ? static_cast<double>(render.crop->Area())
                                    : static_cast<double>(render.width) * static_cast<double>(render.height);
  return pixels *
         (price_beside_slope * SecondsToEncodeAPixel(format, options.encoding, Slope()) + seconds_to_compose_a_pixel);
}

Budget BudgetWithFinish(const Options& options) {
  Budget budget = options.render.budget;
  if (budget.seconds == 0) return budget;
  budget.seconds_to_finish = FinishingTimeOf(*FormatOfPicture(options.picture), options);
  if (options.render.denoise) budget.seconds_to_filter = SecondsToFilter(options.render);
  return budget;
}

}  // namespace ray
