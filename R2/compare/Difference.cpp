#include "R2/compare/Difference.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "R1/Elementary.h"

namespace R2 {
namespace {

using Channels = std::array<double, 3>;

Channels ToChannels(const Color& c) { return {c.r, c.g, c.b}; }

bool IsFinite(const Color& c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

double SquaredLength(const Color& c) { return c.r * c.r + c.g * c.g + c.b * c.b; }

bool HaveOneSize(const Image& a, const Image& b) { return a.Width() == b.Width() && a.Height() == b.Height(); }

double RelativeSquare(const Color& x, const Color& r) {
  constexpr double dark = 0.01;  // keeps black pixels of the reference from dominating
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const auto channel = static_cast<std::size_t>(i);
    const double reference = ToChannels(r)[channel];
    const double difference = ToChannels(x)[channel] - reference;
    sum += difference * difference / (reference * reference + dark);
  }
  return sum;
}

void Widen(LargestDifference& largest, const Color& difference, int x, int y) {
  const Channels channels = ToChannels(difference);
  for (int i = 0; i < 3; ++i) {
    const double value = std::abs(channels[static_cast<std::size_t>(i)]);
    if (value > largest.value) largest = {value, x, y, i};
  }
}

}  // namespace

Color Displayed(const Color& c, Display display) {
  const Color clamped{Clamped(c.r), Clamped(c.g), Clamped(c.b)};
  return display == Display::srgb ? EncodeSrgb(clamped) : clamped;
}

Image Displayed(const Image& image, Display display) {
  Image displayed(image.Width(), image.Height());
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) displayed.Set(x, y, Displayed(image.At(x, y), display));
  return displayed;
}

Difference Compare(const Image& x, const Image& r, Display display) {
  assert(HaveOneSize(x, r));
  Difference result;
  double square = 0, relative = 0, display_square = 0;
  Color sum;
  for (int row = 0; row < x.Height(); ++row)
    for (int column = 0; column < x.Width(); ++column) {
      const Color a = x.At(column, row), b = r.At(column, row);
      ++result.pixels;
      if (!IsFinite(a) || !IsFinite(b)) {
        ++result.pixels_not_finite;
        continue;
      }
      const Color difference = a - b;
      square += SquaredLength(difference);
      relative += RelativeSquare(a, b);
      display_square += SquaredLength(Displayed(a, display) - Displayed(b, display));
      sum += difference;
      Widen(result.largest, difference, column, row);
    }
  const auto finite = static_cast<double>(result.pixels - result.pixels_not_finite);
  result.rmse = std::sqrt(square / (3 * finite));
  result.relative_mse = relative / (3 * finite);
  result.display_rmse = 255 * std::sqrt(display_square / (3 * finite));
  result.psnr = -10 * R1::Log10(display_square / (3 * finite));
  result.bias = sum / finite;
  if (finite == 0) result.largest.value = std::numeric_limits<double>::quiet_NaN();
  return result;
}

double ProductMse(const Image& x, const Image& r1, const Image& r2) {
  assert(HaveOneSize(x, r1) && HaveOneSize(x, r2));
  double sum = 0, finite = 0;
  for (int row = 0; row < x.Height(); ++row)
    for (int column = 0; column < x.Width(); ++column) {
      const Color a = x.At(column, row), b = r1.At(column, row), c = r2.At(column, row);
      if (!IsFinite(a) || !IsFinite(b) || !IsFinite(c)) continue;
      const Color product = (a - b) * (a - c);
      sum += product.r + product.g + product.b;
      ++finite;
    }
  return sum / (3 * finite);
}

std::int64_t PixelsBeyond(const Image& x, const Image& r, double threshold) {
  assert(HaveOneSize(x, r));
  std::int64_t count = 0;
  for (int row = 0; row < x.Height(); ++row)
    for (int column = 0; column < x.Width(); ++column) {
      const Channels difference = ToChannels(x.At(column, row) - r.At(column, row));
      // NaN fails the comparison, and the difference of infinities is NaN or infinite.
      const auto is_within = [&](double d) { return std::isfinite(d) && std::abs(d) <= threshold; };
      if (!std::ranges::all_of(difference, is_within)) ++count;
    }
  return count;
}

Plane DisplayDifference(const Image& x, const Image& r, Display display) {
  assert(HaveOneSize(x, r));
  Plane plane(x.Width(), x.Height());
  for (int row = 0; row < x.Height(); ++row)
    for (int column = 0; column < x.Width(); ++column) {
      const Channels d = ToChannels(Displayed(x.At(column, row), display) - Displayed(r.At(column, row), display));
      plane.Row(row)[column] = static_cast<float>(std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])}));
    }
  return plane;
}

Image SignedDifference(const Image& x, const Image& r) {
  assert(HaveOneSize(x, r));
  constexpr double gain = 4;
  Image image(x.Width(), x.Height());
  for (int row = 0; row < image.Height(); ++row)
    for (int column = 0; column < image.Width(); ++column) {
      const Color d = gain * (x.At(column, row) - r.At(column, row));
      const double more = std::max({d.r, d.g, d.b, 0.0}), less = -std::min({d.r, d.g, d.b, 0.0});
      image.Set(column, row, {std::min(1.0, more), std::min(1.0, std::min(more, less)), std::min(1.0, less)});
    }
  return image;
}

}  // namespace R2
