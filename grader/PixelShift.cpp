#include "grader/PixelShift.h"

#include <array>

#include "R2/Plane.h"

namespace ray::grade {
namespace {

constexpr int blur_reach = 2, blurs = 3;              // radius of each, in pixels
constexpr int shift_margin = blurs * blur_reach + 2;  // so that no shift or blur reads beyond the edge

R2::Plane LuminanceOf(const R2::Image& image) {
  R2::Plane plane(image.Width(), image.Height());
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) plane.Row(y)[x] = static_cast<float>(Luminance(image.At(x, y)));
  return plane;
}

/// Blurs by the binomial weights of five pixels along one axis, except at the edges.
R2::Plane BlurredAlong(const R2::Plane& plane, int step_x, int step_y) {
  constexpr std::array weights{1 / 16.0F, 4 / 16.0F, 6 / 16.0F, 4 / 16.0F, 1 / 16.0F};
  R2::Plane blurred = plane;
  for (int y = blur_reach; y < plane.height - blur_reach; ++y)
    for (int x = blur_reach; x < plane.width - blur_reach; ++x) {
      float sum = 0;
      for (int k = -blur_reach; k <= blur_reach; ++k)
        sum += weights[static_cast<std::size_t>(k + blur_reach)] * plane.Row(y + k * step_y)[x + k * step_x];
      blurred.Row(y)[x] = sum;
    }
  return blurred;
}

R2::Plane Blurred(const R2::Image& image) {
  R2::Plane plane = LuminanceOf(image);
  for (int i = 0; i < blurs; ++i) plane = BlurredAlong(BlurredAlong(plane, 1, 0), 0, 1);
  return plane;
}

/// Returns the plane's value between its pixels, at halves of them.
float At(const R2::Plane& plane, int halves_x, int halves_y) {
  const int x = halves_x >> 1, y = halves_y >> 1, right = x + (halves_x & 1), above = y + (halves_y & 1);
  return (plane.Row(y)[x] + plane.Row(y)[right] + plane.Row(above)[x] + plane.Row(above)[right]) / 4;
}

double SquaresWith(const R2::Plane& image, const R2::Plane& reference, int halves_right, int halves_up) {
  double sum = 0;
  for (int y = shift_margin; y < image.height - shift_margin; ++y)
    for (int x = shift_margin; x < image.width - shift_margin; ++x) {
      const double d = image.Row(y)[x] - At(reference, 2 * x - halves_right, 2 * y - halves_up);
      sum += d * d;
    }
  return sum;
}

}  // namespace

std::optional<PixelShift> BestShift(const R2::Image& image, const R2::Image& reference) {
  constexpr int least_side = 3 * shift_margin, most_halves = 2;
  if (image.Width() < least_side || image.Height() < least_side) return {};
  const R2::Plane a = Blurred(image), b = Blurred(reference);
  const double unshifted = SquaresWith(a, b, 0, 0);
  if (!(unshifted > 0)) return {};
  PixelShift best;
  for (int up = -most_halves; up <= most_halves; ++up)
    for (int right = -most_halves; right <= most_halves; ++right) {
      const double share = 1 - SquaresWith(a, b, right, up) / unshifted;
      if (share > best.share) best = {right, up, share};
    }
  if (!(best.share > 0)) return {};
  return best;
}

}  // namespace ray::grade
