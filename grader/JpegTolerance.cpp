#include "grader/JpegTolerance.h"

#include <algorithm>

#include "R2/ImageFile.h"
#include "grader/SceneImages.h"

namespace ray::grade {

R2::Image AsJpeg(const R2::Image& image) {
  constexpr int usual_quality = 75;
  const R2::ImageFormat* jpeg = R2::FormatForName("x.jpg");
  return R2::DecodeImage(jpeg->encode(image, {.jpeg_quality = usual_quality}, {})).image;
}

double LargestAround(const R2::Image& a, const R2::Image& b, int x, int y) {
  double largest = 0;
  for (int j = std::max(0, y - 2); j <= std::min(a.Height() - 1, y + 2); ++j)
    for (int i = std::max(0, x - 2); i <= std::min(a.Width() - 1, x + 2); ++i)
      largest = std::max(largest, LargestChannel(a.At(i, j) - b.At(i, j)));
  return largest;
}

bool DiffersLikeJpeg(const R2::Image& image, const R2::Image& reference) {
  constexpr double rounding = 2.0 / 255;
  constexpr std::int64_t of_pixels = 200;  // one in this many pixels may differ by more
  const R2::Image compressed = AsJpeg(reference);
  std::int64_t beyond = 0;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const double difference = LargestChannel(image.At(x, y) - reference.At(x, y));
      beyond += difference > rounding && difference > rounding + LargestAround(reference, compressed, x, y);
    }
  return beyond * of_pixels <= std::int64_t{image.Width()} * image.Height();
}

}  // namespace ray::grade
