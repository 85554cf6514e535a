#include <algorithm>
#include <array>
#include <limits>

#include "R1/Elementary.h"

namespace R1 {
namespace {

/// Returns the angle of the point (x, y) from the x axis, y >= 0; the larger of |x| and y is within 2^-400 and 2^400.
/// With n the smaller of them and d the larger, the nearest b = i/16 to n/d is split off first: atan(n/d) = atan b +
/// atan((n - b d) / (d + b n)).
inline double UpperAngle(const DoubleDouble& y, const DoubleDouble& x) {
  const double across = std::abs(x.high), n = std::min(across, y.high), d = std::max(across, y.high);
  const bool is_steep = y.high > across, is_left = std::signbit(x.high);
  const double across_low = is_left ? -x.low : x.low;
  const double n_low = is_steep ? across_low : y.low, d_low = is_steep ? y.low : across_low;
  const Nearest i(16 * (n / d));
  const double b = i.Value() / 16, d_head = Head(d);
  // b has 5 bits, so both products and the first difference are exact.
  const double first = n - b * d_head, second = b * (d - d_head), over = first - second, under = d + b * n;
  const double over_low = ((first - over) - second) + (n_low - b * d_low), under_low = (d - under) + b * n + d_low;
  // over / under = ratio + rest, where ratio has 26 bits.
  const double per_under = 1 / under, ratio = Head(over * per_under), under_head = Head(under);
  const double rest =
      (((over - ratio * under_head) - ratio * (under - under_head)) + (over_low - ratio * under_low)) * per_under;
  constexpr std::array<double, 4> sign{1, -1, -1, 1};
  const std::size_t octant = is_steep + 2 * is_left;
  const auto& known = coefficients::arctangents[octant][i.Bits() & 31];
  const DoubleDouble sum = QuickSum(known.high, sign[octant] * ratio);
  return sum.high + (sum.low + (known.low + sign[octant] * (rest + ArctangentLessRatio(ratio + rest))));
}

/// Returns sqrt(1 - x^2), |x| <= 1.
DoubleDouble OtherLeg(double x) {
  const DoubleDouble less = QuickSum(1, -x), more = QuickSum(1, x), product = SplitProduct(less.high, more.high);
  const DoubleDouble square = QuickSum(product.high, product.low + (less.high * more.low + less.low * more.high));
  const double root = std::sqrt(square.high);
  if (root == 0) return 0.0;
  const DoubleDouble back = SplitProduct(root, root);
  return QuickSum(root, (((square.high - back.high) - back.low) + square.low) / (2 * root));
}

}  // namespace

double Atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  const double larger = std::max(std::abs(x), std::abs(y));
  if (larger == 0) return std::copysign(std::signbit(x) ? coefficients::pi.high : 0.0, y);
  if (std::abs(y) < 0x1p-60 * x) return y / x;  // the next term is under 2^-120 of it
  if (std::isinf(larger)) {                     // treats all finite numbers as 0
    x = std::copysign(std::isinf(x) ? 1.0 : 0.0, x);
    y = std::copysign(std::isinf(y) ? 1.0 : 0.0, y);
  } else if (!(larger >= 0x1p-400 && larger <= 0x1p400)) {
    const double scale = larger < 1 ? 0x1p700 : 0x1p-700;
    x *= scale, y *= scale;
  }
  return std::copysign(UpperAngle(std::abs(y), x), y);
}

double Atan(double x) { return Atan2(x, 1); }

double Asin(double x) {
  if (!(std::abs(x) <= 1)) return std::numeric_limits<double>::quiet_NaN();
  return std::copysign(UpperAngle(std::abs(x), OtherLeg(x)), x);
}

double Acos(double x) {
  if (!(std::abs(x) <= 1)) return std::numeric_limits<double>::quiet_NaN();
  return UpperAngle(OtherLeg(x), x);
}

}  // namespace R1
