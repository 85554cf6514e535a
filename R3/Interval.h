#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/Numeric.h"

/// Bounds of unknown numbers. Every bound is rounded outward, so that the exact value always stays inside.
///   source   Moore, Interval Analysis (1966)
namespace R3 {

struct Interval {
  double low = 0, high = 0;

  Interval() = default;
  Interval(double x) : low(x), high(x) {}  // implicit: a number is an interval
  Interval(double l, double h) : low(l), high(h) {}

  static Interval Whole() { return {-infinity, infinity}; }
  bool Holds(double x) const { return low <= x && x <= high; }
};

/// Selects one of two intervals without a branch.
inline Interval Choice(bool is_first, const Interval& a, const Interval& b) {
  return {is_first ? a.low : b.low, is_first ? a.high : b.high};
}

/// Widens an interval by at least `bits` last bits at both ends; returns all numbers if an end is NaN. A share of 2^-52
/// is one or two last bits, and the smallest normal number covers values that are too small for that. Cheaper than
/// NextUp, since it needs no branch.
inline Interval Outward(double low, double high, int bits = 1) {
  constexpr double least = std::numeric_limits<double>::min();
  const double share = bits * 2 * unit_roundoff, ends = bits * least;
  const Interval wider{low - (std::abs(low) * share + ends), high + (std::abs(high) * share + ends)};
  return Choice(wider.low <= wider.high, wider, Interval::Whole());
}

inline Interval Hull(const Interval& a, const Interval& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
/// Returns the interval, clipped at 0 if the exact value is known to be 0 or more. Rounding outward would otherwise
/// make its square root undefined.
inline Interval NotNegative(bool is_known, const Interval& a) {
  return {is_known ? std::max(a.low, 0.0) : a.low, a.high};
}
inline Interval operator+(const Interval& a, const Interval& b) {
  return NotNegative(a.low >= 0 && b.low >= 0, Outward(a.low + b.low, a.high + b.high));
}
inline Interval operator-(const Interval& a, const Interval& b) { return Outward(a.low - b.high, a.high - b.low); }
inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  const bool all_numbers = !std::isnan(p + q + (r + s));  // also false if some are infinite
  const Interval product = Outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
  return Choice(all_numbers, product, Interval::Whole());
}
inline Interval operator/(const Interval& a, const Interval& b) {
  return Choice(b.Holds(0), Interval::Whole(), a * Outward(1 / b.high, 1 / b.low));
}

// R1's functions are off by less than an ulp.
inline Interval Exp(const Interval& a) {
  const Interval e = Outward(R1::Exp(a.low), R1::Exp(a.high), 2);
  return {std::max(e.low, 0.0), e.high};
}
/// Returns the whole line if the argument may not be positive.
inline Interval Log(const Interval& a) {
  return a.low > 0 ? Outward(R1::Log(a.low), R1::Log(a.high), 2) : Interval::Whole();
}
inline Interval Sqrt(const Interval& a) {
  if (!(a.low >= 0)) return Interval::Whole();
  const Interval root = Outward(std::sqrt(a.low), std::sqrt(a.high));
  return {std::max(root.low, 0.0), root.high};
}
inline Interval Abs(const Interval& a) {
  if (a.low >= 0) return a;
  return a.high <= 0 ? -a : Interval{0, std::max(-a.low, a.high)};
}

/// Returns true if the interval may contain one of start + k period.
inline bool MayHold(const Interval& a, double start, double period) {
  // The rounding of these few operations is much less than this share, in periods.
  const double pad = 0x1p-48 * (1 + std::abs(a.low) + std::abs(a.high));
  return std::floor((a.high - start) / period + pad) >= std::ceil((a.low - start) / period - pad);
}
inline Interval Cos(const Interval& a) {
  constexpr double turn = 2 * std::numbers::pi;
  if (!(a.high - a.low < turn)) return {-1, 1};
  const double p = R1::Cos(a.low), q = R1::Cos(a.high);
  const Interval ends = Outward(std::min(p, q), std::max(p, q), 2);
  return {MayHold(a, std::numbers::pi, turn) ? -1 : std::max(ends.low, -1.0),
          MayHold(a, 0, turn) ? 1 : std::min(ends.high, 1.0)};
}
inline Interval Sin(const Interval& a) {
  constexpr double turn = 2 * std::numbers::pi, quarter = std::numbers::pi / 2;
  if (!(a.high - a.low < turn)) return {-1, 1};
  const double p = R1::Sin(a.low), q = R1::Sin(a.high);
  const Interval ends = Outward(std::min(p, q), std::max(p, q), 2);
  return {MayHold(a, -quarter, turn) ? -1 : std::max(ends.low, -1.0),
          MayHold(a, quarter, turn) ? 1 : std::min(ends.high, 1.0)};
}

/// Returns a^n for n >= 1. R1::WholePower is off by at most 2 n u.
inline Interval WholePower(const Interval& a, std::uint32_t n) {
  const Interval base = n % 2 == 0 ? Abs(a) : a;
  const auto outward = [&](double power, double sign) {
    return power + sign * std::abs(power) * (4 * n * unit_roundoff);
  };
  return NotNegative(n % 2 == 0,
                     Outward(outward(R1::WholePower(base.low, n), -1), outward(R1::WholePower(base.high, n), 1)));
}

}  // namespace R3
