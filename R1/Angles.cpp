#include <initializer_list>

#include "R1/Elementary.h"

namespace R1 {
namespace {

__extension__ typedef unsigned __int128 Wide;

/// An angle reduced by whole quarter turns.
struct Reduced {
  std::uint64_t quarters = 0;  // modulo 4
  DoubleDouble angle;          // |high| <= pi/4, up to rounding
};

/// Returns 64 bits of 2/pi, the first of weight 2^-(first + 1); bits before the point are 0.
std::uint64_t BitsOfTwoOverPi(int first) {
  const auto word = [](int i) { return i < 0 ? 0 : coefficients::two_over_pi[i]; };
  const int i = first >= 0 ? first / 64 : -((63 - first) / 64), shift = first - 64 * i;
  return shift == 0 ? word(i) : word(i) << shift | word(i + 1) >> (64 - shift);
}

/// Reduces any finite angle except tiny ones, with a relative error under 2^-70. With x = m 2^e, bits of 2/pi above
/// 2^(2 - e) give whole turns; 192 bits after them leave an error under 2^-137, and no double is nearer than 2^-62 to a
/// multiple of pi/2.
///   source   Payne and Hanek (1983); the distance: Muller, Elementary Functions (2016), section 11.2
Reduced ReduceExactly(double x) {
  int exponent = 0;
  const auto m = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(x), &exponent), 53));
  const int first = exponent - 53 - 2;
  // The product modulo 2^192, which is four quarter turns.
  const Wide low = Wide{m} * BitsOfTwoOverPi(first + 128);
  const Wide middle = Wide{m} * BitsOfTwoOverPi(first + 64) + (low >> 64);
  const std::uint64_t high = m * BitsOfTwoOverPi(first) + static_cast<std::uint64_t>(middle >> 64);
  std::uint64_t words[] = {high << 2 | static_cast<std::uint64_t>(middle) >> 62,
                           static_cast<std::uint64_t>(middle) << 2 | static_cast<std::uint64_t>(low) >> 62,
                           static_cast<std::uint64_t>(low) << 2};
  const bool is_above_half = words[0] >> 63;
  Reduced reduced{(high >> 62) + is_above_half, {}};
  if (is_above_half)
    for (std::uint64_t& w : words) w = ~w;  // from above; the missing unit is 2^-190
  DoubleDouble fraction;
  double unit = 0x1p-32;
  for (const std::uint64_t w : words)
    for (const int shift : {32, 0}) {
      fraction = fraction + DoubleDouble(unit * static_cast<double>(w >> shift & 0xffffffff));
      unit *= 0x1p-32;
    }
  const DoubleDouble product = SplitProduct(fraction.high, coefficients::half_pi.high);
  reduced.angle = QuickSum(product.high, product.low + (fraction.high * coefficients::half_pi.low +
                                                        fraction.low * coefficients::half_pi.high));
  if (is_above_half != std::signbit(x)) reduced.angle = -reduced.angle;
  if (std::signbit(x)) reduced.quarters = -reduced.quarters;
  return reduced;
}

/// Reduces any finite angle.
Reduced Reduce(double x) {
  if (std::abs(x) <= coefficients::half_pi.high / 2) return {0, x};
  if (!(std::abs(x) < 0x1p20)) return ReduceExactly(x);
  const Nearest quarters(x * coefficients::two_over_pi_rounded);
  const double n = quarters.Value();
  const auto& parts = coefficients::half_pi_parts;
  const DoubleDouble rest = ExactSum(x - n * parts[0], -(n * parts[1]));
  // The omitted part is under 2^20 2^-121. If cancellation makes that significant, ReduceExactly takes over.
  if (!(std::abs(rest.high) > 0x1p-20)) return ReduceExactly(x);
  return {quarters.Bits(), QuickSum(rest.high, rest.low - n * parts[2])};
}

}  // namespace

SineCosine SinCos(double angle) {
  if (!std::isfinite(angle)) return {angle - angle, angle - angle};
  if (angle == 0) return {angle, 1};
  const Reduced reduced = Reduce(angle);
  return Turned(SinCosNearZero(reduced.angle.high, reduced.angle.low), reduced.quarters);
}

double Sin(double angle) { return SinCos(angle).sine; }
double Cos(double angle) { return SinCos(angle).cosine; }

double Tan(double angle) {
  if (!std::isfinite(angle)) return angle - angle;
  if (std::abs(angle) < 0x1p-28) return angle;  // the next term is under 2^-56 / 3 of it
  const Reduced reduced = Reduce(angle);
  const auto [high, low] = reduced.angle;
  const DoubleDouble sine = QuickSum(high, SineLessAngle(high, low));
  const double z = high * high;
  const DoubleDouble square = SplitProduct(high, high), near_one = ExactSum(1, -0.5 * square.high);
  const DoubleDouble cosine = QuickSum(
      near_one.high, near_one.low - 0.5 * square.low - high * low + z * z * Polynomial(coefficients::cosine, z));
  return static_cast<double>(reduced.quarters & 1 ? -SplitQuotient(cosine, sine) : SplitQuotient(sine, cosine));
}

}  // namespace R1
