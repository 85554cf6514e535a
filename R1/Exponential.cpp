#include <limits>

#include "R1/Elementary.h"

namespace R1 {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr int mantissa_bits = 52;

/// Returns 2^exponent, -1022 <= exponent <= 1023.
double PowerOfTwo(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << mantissa_bits);
}

/// The factors of exp(x): 2^exponent power (1 + large + small).
struct Exponential {
  double power, large, small;
  int exponent;
};

/// Returns exp(high + low), |high| < 800, |low| <= 1.
Exponential ExponentialOf(double high, double low) {
  const Nearest steps(high * coefficients::exp_steps_per_unit);
  const double n = steps.Value();
  const DoubleDouble r = QuickSum(high - n * coefficients::exp_step.high, low - n * coefficients::exp_step.low);
  const auto bits = static_cast<std::int64_t>(steps.Bits() << 13) >> 13;  // n as an integer, whatever its sign
  const auto& power = coefficients::powers[bits & (coefficients::exp_steps - 1)];
  return {power.high, r.high, power.low * (1 + r.high) + (r.low + ExponentialCurve(r.high)),
          static_cast<int>(bits >> 7)};
}

/// Returns exp(high + low) for all numbers but NaN.
double ExpOfSum(double high, double low) {
  if (!(high < 710)) return infinite;
  if (!(high > -746)) return 0;  // the smallest positive double is exp(-744.4)
  const Exponential e = ExponentialOf(high, low);
  const double mantissa = e.power + e.power * (e.large + e.small);
  if (std::abs(high) < 700) return mantissa * PowerOfTwo(e.exponent);
  // In two steps, the first of them exact, since 2^1024 and 2^-1074 are not normal numbers.
  const int half = e.exponent / 2;
  return mantissa * PowerOfTwo(half) * PowerOfTwo(e.exponent - half);
}

/// Returns log x for 0 < x < infinity, with a relative error under 2^-65; low is under 2^-16 high.
DoubleDouble LogarithmOf(double x) {
  int shift = 0;
  if (x < std::numeric_limits<double>::min()) x *= 0x1p54, shift = -54;
  const auto bits = std::bit_cast<std::uint64_t>(x), from_first = bits - coefficients::log_first;
  const int exponent = static_cast<int>(static_cast<std::int64_t>(from_first) >> mantissa_bits);
  const auto& entry = coefficients::logarithms[(from_first >> (mantissa_bits - 7)) & (coefficients::log_steps - 1)];
  const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(exponent) << mantissa_bits));
  // m/c - 1 = head + tail, both exact: 22 bits of m times 12, and the other 31 times 12; the square of head is exact
  // too. Head is rounded to nearest, so that it is 0 next to 1, where it would cancel.
  const double m_head =
      std::bit_cast<double>((std::bit_cast<std::uint64_t>(m) + 0x40000000) & ~std::uint64_t{0x7fffffff});
  const double head = m_head * entry.inverse - 1, tail = (m - m_head) * entry.inverse, r = head + tail;
  const double n = exponent + shift;
  // The first sum is exact, since its terms are multiples of 2^-42. Unless it is 0, it is larger than head, and tail is
  // smaller than any nonzero result of adding head.
  const DoubleDouble table = QuickSum(n * coefficients::log_2.high + entry.high, head);
  const DoubleDouble squared = QuickSum(table.high, -0.5 * head * head), all = QuickSum(squared.high, tail);
  const double curve = r * r * r * LogarithmCurve(r) - tail * (head + 0.5 * tail);
  return {all.high, curve + ((all.low + squared.low) + (table.low + (entry.low + n * coefficients::log_2.low)))};
}

/// Returns the logarithm of a number outside of (0, infinity).
double OddLogarithm(double x) {
  if (x == 0) return -infinite;
  return x > 0 ? x : not_a_number;
}

bool IsInteger(double y) { return std::nearbyint(y) == y; }
bool IsOdd(double y) { return IsInteger(y) && std::abs(y) < 0x1p53 && !IsInteger(0.5 * y); }

/// Returns x^y, 0 < x < infinity, y finite.
double PowOfPositive(double x, double y) {
  const DoubleDouble logarithm = LogarithmOf(x);
  const double y_head = Head(y), head = Head(logarithm.high);
  return ExpOfSum(y_head * head, (y - y_head) * head + y * ((logarithm.high - head) + logarithm.low));
}

/// Returns x^y for x = 0 or infinite x.
double PowOfExtreme(double x, double y) {
  const double size = (x == 0) == (y < 0) ? infinite : 0;
  return IsOdd(y) ? std::copysign(size, x) : size;
}

}  // namespace

double Exp(double x) { return std::isnan(x) ? x : ExpOfSum(x, 0); }
double Exp2(double x) { return Pow(2, x); }

double Expm1(double x) {
  if (!(std::abs(x) > 0x1p-54)) return x;
  if (x > 710) return infinite;
  if (x < -40) return -1;  // exp(-40) is under half an ulp of 1
  const Exponential e = ExponentialOf(x, 0);
  const int half = e.exponent / 2;
  const double scale = PowerOfTwo(half), other = PowerOfTwo(e.exponent - half), power = scale * e.power;
  const DoubleDouble whole = ExactSum(power, -1 / other), part = SplitProduct(power, e.large);
  const DoubleDouble sum = ExactSum(whole.high, part.high);
  return (sum.high + (sum.low + (whole.low + part.low + power * e.small))) * other;
}

double Log(double x) {
  if (!(x > 0 && x < infinite)) return OddLogarithm(x);
  return static_cast<double>(LogarithmOf(x));
}

double Log1p(double x) {
  if (!(x > -1 && x < infinite)) return x == -1 ? -infinite : OddLogarithm(x);
  if (std::abs(x) < 0x1p-27) return x - x * x * (0.5 - x * coefficients::third.high);
  const DoubleDouble sum = ExactSum(1, x);
  const DoubleDouble logarithm = LogarithmOf(sum.high);
  const double missing = sum.low / sum.high;
  const DoubleDouble result = ExactSum(logarithm.high, missing);
  return result.high + (result.low + (logarithm.low - 0.5 * missing * missing));
}

double Log10(double x) {
  if (!(x > 0 && x < infinite)) return OddLogarithm(x);
  const DoubleDouble logarithm = LogarithmOf(x), product = SplitProduct(logarithm.high, coefficients::log10_e.high);
  return product.high +
         (product.low + (logarithm.high * coefficients::log10_e.low + logarithm.low * coefficients::log10_e.high));
}

// Flattened, since most of the time for highlights is spent here.
[[gnu::flatten]] double Pow(double x, double y) {
  if (x > 0 && x < infinite && std::abs(y) < infinite) return PowOfPositive(x, y);
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return x + y;
  if (x == 0 || std::isinf(x)) return PowOfExtreme(x, y);
  const double size = std::abs(x);
  if (std::isinf(y)) return size == 1 ? 1 : (size > 1) == (y > 0) ? infinite : 0;
  if (x < 0 && !IsInteger(y)) return not_a_number;
  const double power = PowOfPositive(size, y);
  return x < 0 && IsOdd(y) ? -power : power;
}

double Cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  const DoubleDouble logarithm = LogarithmOf(std::abs(x)), third{coefficients::third.high, coefficients::third.low};
  const DoubleDouble product = SplitProduct(logarithm.high, third.high);
  return std::copysign(ExpOfSum(product.high, product.low + (logarithm.high * third.low + logarithm.low * third.high)),
                       x);
}

double Hypot(double x, double y) {
  x = std::abs(x), y = std::abs(y);
  if (std::isinf(x) || std::isinf(y)) return infinite;
  double large = x > y ? x : y, small = x > y ? y : x, scale = 1;
  if (large == 0 || !(small >= 0)) return large + small;
  if (large < 0x1p-400) large *= 0x1p600, small *= 0x1p600, scale = 0x1p-600;
  if (large > 0x1p400) large *= 0x1p-600, small *= 0x1p-600, scale = 0x1p600;
  const DoubleDouble a = SplitProduct(large, large), b = SplitProduct(small, small), sum = QuickSum(a.high, b.high);
  const double root = std::sqrt(sum.high);
  const DoubleDouble back = SplitProduct(root, root);
  return scale * (root + ((((sum.high - back.high) - back.low) + sum.low) + (a.low + b.low)) / (2 * root));
}

}  // namespace R1
