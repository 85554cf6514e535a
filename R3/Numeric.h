#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "R1/DoubleDouble.h"

/// Floating-point arithmetic with stated errors. u below is the unit roundoff of double.
namespace R3 {

using R1::DoubleDouble, R1::ExactProduct, R1::ExactSum, R1::QuickSum;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double unit_roundoff = 0x1p-53;

/// Returns a bound on the relative error of n consecutive roundings: n u / (1 - n u).
/// Source: Higham, Accuracy and Stability of Numerical Algorithms (2002), lemma 3.1.
constexpr double Gamma(int n) { return n * unit_roundoff / (1 - n * unit_roundoff); }

/// Compiles a function in several versions on x86-64, with fused multiply-add instructions and without, where std::fma
/// is a library call; the best version for the processor is selected at start-up. Functions that it calls are inlined,
/// so that they are selected too. All versions give the same bits, because fma is exact by definition and contraction
/// is off. Sanitizers cannot run the selection. Levels, not names of processors: "arch=haswell" would match that
/// processor only.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__FMA__) && \
    defined(__GNUC__) && !defined(__clang__)
#define R3_COMPILED_FOR(...) __attribute__((flatten, target_clones("default", __VA_ARGS__)))
#else
#define R3_COMPILED_FOR(...)
#endif
#define R3_USES_FMA R3_COMPILED_FOR("arch=x86-64-v3")

/// R3_USES_FMA for loops over arrays, whose instructions process four or eight doubles at once instead of two. Loop
/// bodies must have no branches; selections are fine.
#define R3_VECTORIZED R3_COMPILED_FOR("arch=x86-64-v3", "arch=x86-64-v4")

/// Returns a b - c d with an error of at most 1.5 ulp and the exact sign, barring underflow.
/// Source: Jeannerod, Louvet, Muller, Further analysis of Kahan's algorithm (2013), theorem 1.1.
inline double DifferenceOfProducts(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/// The range for squared lengths in which no rounding of a product of three lengths overflows or underflows. Lengths
/// outside are scaled by a power of two, which changes no bit of the result.
inline constexpr double least_square = 0x1p-600, most_square = 0x1p600;
inline bool IsInRange(double square) { return square >= least_square && square <= most_square; }

/// Returns a power of two that scales a positive number into [1, 2) exactly; denormal numbers only as far as 2^1022
/// does. For 0, infinity and NaN the result is finite and above 0.
inline double InversePower(double x) {
  constexpr std::uint64_t exponent_bits = std::uint64_t{0x7FF} << 52, twice_the_bias = std::uint64_t{2046} << 52;
  const double power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & exponent_bits);
  const double at_least = power > 0x1p-1022 ? power : 0x1p-1022, in_range = at_least < 0x1p1022 ? at_least : 0x1p1022;
  return std::bit_cast<double>(twice_the_bias - std::bit_cast<std::uint64_t>(in_range));
}

/// Returns the double at a share, in [0, 1], of the doubles from low to high, both finite. Bisection by it ends in
/// neighboring doubles within 64 steps for any ends, also at 0.
inline double AmongDoubles(double low, double high, double share) {
  // Signed integers in the order of the doubles: those of negative doubles are mirrored.
  const auto number_of = [](double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
  };
  const std::int64_t first = number_of(low), last = number_of(high);
  const double distance = static_cast<double>(static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first));
  const auto steps = static_cast<std::uint64_t>(share * distance);
  const auto number = static_cast<std::int64_t>(static_cast<std::uint64_t>(first) + steps);
  if (number >= last) return high;
  return std::bit_cast<double>(number >= 0 ? number : std::numeric_limits<std::int64_t>::min() - number);
}

/// Returns the next double above x; infinity and NaN stay.
inline double NextUp(double x) {
  if (!(x < infinity)) return x;
  if (x == 0) return std::numeric_limits<double>::denorm_min();
  const auto bits = std::bit_cast<std::uint64_t>(x);
  return std::bit_cast<double>(x > 0 ? bits + 1 : bits - 1);
}

/// Returns the next double below x; minus infinity and NaN stay.
inline double NextDown(double x) { return -NextUp(-x); }

}  // namespace R3
