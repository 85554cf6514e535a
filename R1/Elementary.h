#pragma once

#include <cassert>
#include <cmath>
#include <cstdint>

#include "R1/DoubleDouble.h"
#include "R1/Kernels.h"

/// Elementary functions made only of + - * /, the square root and integer operations, each rounded separately. They
/// give the same bits on every processor and with every C library, which the C library's functions do not. Everything
/// that affects an image uses them (`make check`).
///   accuracy   the largest error seen in tests/R1/Elementary.cpp against 113 bits, in ulp of the result, is under the
///              number given with each function
///   limits     infinities, NaN, signed zeros and poles as in ISO C, annex F; no errno, no exception flags
///   source     arguments are reduced as in Cody and Waite, Software Manual for the Elementary Functions (1980),
///              Payne and Hanek, Radian reduction for trigonometric functions (1983), and Tang, Table-driven
///              implementation of the exponential (1989) and of the logarithm function (1990);
///              script/elementary.py derives all numbers
namespace R1 {

struct SineCosine {
  double sine = 0, cosine = 1;
};

// Angles in radians, of any size.
SineCosine SinCos(double angle);  // .8 ulp each
double Sin(double angle);
double Cos(double angle);
double Tan(double angle);  // .95 ulp

double Asin(double x);             // .55 ulp
double Acos(double x);             // .55 ulp
double Atan(double x);             // .55 ulp
double Atan2(double y, double x);  // .55 ulp

double Exp(double x);              // .55 ulp; .76 if the result is subnormal
double Exp2(double x);             // .55 ulp; .76 if the result is subnormal
double Expm1(double x);            // .7 ulp
double Log(double x);              // .55 ulp
double Log1p(double x);            // .55 ulp
double Log10(double x);            // .55 ulp
double Pow(double x, double y);    // .55 ulp; .76 if the result is subnormal
double Cbrt(double x);             // .55 ulp
double Hypot(double x, double y);  // .55 ulp; .76 if the result is subnormal

/// Equals std::floor except for the sign of zero, with half the instructions on processors without SSE4.1.
inline double Floor(double x) {
  constexpr double whole_from = 0x1p52;
  if (!(std::abs(x) < whole_from)) return x;
  const auto towards_zero = static_cast<double>(static_cast<std::int64_t>(x));
  return towards_zero - static_cast<double>(towards_zero > x);
}

/// Returns x^n by repeated squaring: few instructions, and a relative error of at most (n - 1) 2^-53, about what a
/// rounding error of x itself causes.
inline double WholePower(double x, std::uint32_t n) {
  double power = 1;
  for (; n != 0; n >>= 1, x *= x)
    if (n & 1) power *= x;
  return power;
}

/// The largest whole exponent that is raised by squaring.
inline constexpr double most_whole_exponent = 1024;
inline bool IsWholeExponent(double n) { return n <= most_whole_exponent && n == std::floor(n); }

/// Returns cosine^n of Phong's lobe, the cosine in (0, 1], n >= 0; relative error within n 2^-53.
inline double CosinePower(double cosine, double n) {
  return IsWholeExponent(n) ? WholePower(cosine, static_cast<std::uint32_t>(n)) : Pow(cosine, n);
}

/// Returns sine and cosine of high + low, |high| <= pi/4 up to rounding, |low| <= ulp(high)/2.
inline SineCosine SinCosNearZero(double high, double low) {
  return {high + SineLessAngle(high, low), CosineNearZero(high, low)};
}

/// Returns sine and cosine of the angle plus a number of quarter turns, which counts modulo 4.
inline SineCosine Turned(const SineCosine& a, std::uint64_t quarters) {
  const double sine = quarters & 1 ? a.cosine : a.sine, cosine = quarters & 1 ? a.sine : a.cosine;
  return {quarters & 2 ? -sine : sine, (quarters + 1) & 2 ? -cosine : cosine};
}

/// The integer nearest to x, |x| < 2^51, ties to even, with its lowest bits as those of an integer.
struct Nearest {
  explicit Nearest(double x) : shifted(x + 0x1.8p52) {}
  double Value() const { return shifted - 0x1.8p52; }
  std::uint64_t Bits() const { return std::bit_cast<std::uint64_t>(shifted); }

  double shifted;  // the sum has ulp 1
};

/// Returns sine and cosine of an angle in whole turns, from -1/8 to 1/8; .8 ulp each.
inline SineCosine SinCosEighth(double turns) {
  const double head = Head(turns), angle = head * coefficients::two_pi.high;  // 26 bits times 26 bits
  const DoubleDouble sum =
      QuickSum(angle, (turns - head) * coefficients::two_pi.high + turns * coefficients::two_pi.low);
  return SinCosNearZero(sum.high, sum.low);
}

/// Returns sine and cosine of an angle in whole turns, |turns| < 2^48; .8 ulp each. Reducing the angle is exact, so
/// this is faster than SinCos, and quarter turns give exactly 0 and 1. Unlike SinCosTurns, it does not assert the
/// range, so that loops become vector instructions.
inline SineCosine SinCosTurnsInRange(double turns) {
  const Nearest quarters(4 * turns);
  return Turned(SinCosEighth(turns - 0.25 * quarters.Value()), quarters.Bits());
}
inline SineCosine SinCosTurns(double turns) {
  assert(!(std::abs(turns) >= 0x1p48));
  return SinCosTurnsInRange(turns);
}

}  // namespace R1
