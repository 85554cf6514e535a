#include "grader/JpegTolerance.h"

#include <algorithm>

#include "R2/ImageFile.h"
#include "grader/SceneImages.h"

namespace ray::grade {

R2::Image AsJpeg(const R2::Image& image, int quality) {
  const R2::ImageFormat* jpeg = R2::FormatForName("x.jpg");
  return R2::DecodeImage(jpeg->encode(image, {.jpeg_quality = quality}, {})).image;
}

std::vector<double> LossesOf(const R2::Image& compressed, const R2::Image& original) {
  constexpr int side = 16;  // of the blocks of chroma with 4:2:0
  const int width = original.Width(), height = original.Height();
  const int columns = (width + side - 1) / side, rows = (height + side - 1) / side;
  // Pixel rows count from the bottom, blocks from the top. An edge may lie a pixel farther, in the next block.
  std::vector<double> of_block(static_cast<std::size_t>(columns * rows), 0.0);
  const auto block = [&](int x, int y) -> double& {
    const int column = std::clamp(x, 0, width - 1) / side, row = (height - 1 - std::clamp(y, 0, height - 1)) / side;
    return of_block[static_cast<std::size_t>(row * columns + column)];
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int i : {x - 1, x + 1})
        for (const int j : {y - 1, y + 1}) {
          double& largest = block(i, j);
          largest = std::max(largest, LargestChannel(compressed.At(x, y) - original.At(x, y)));
        }
  std::vector<double> losses;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) losses.push_back(block(x, y));
  return losses;
}

bool DiffersLikeJpeg(const R2::Image& image, const R2::Image& reference) {
  constexpr double rounding = 2.0 / 255;
  constexpr std::int64_t of_pixels = 200;  // one in this many pixels may differ by more
  const std::vector<double> losses = LossesOf(AsJpeg(reference), reference);
  std::int64_t beyond = 0;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const double difference = LargestChannel(image.At(x, y) - reference.At(x, y));
      beyond += difference > rounding + losses[static_cast<std::size_t>(y * image.Width() + x)];
    }
  return beyond * of_pixels <= std::int64_t{image.Width()} * image.Height();
}

}  // namespace ray::grade
