#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace R1 {

/// A number of about 106 bits, kept as the unevaluated sum of two doubles, |low| <= ulp(high)/2. For sums and products
/// that would otherwise lose their digits to cancellation; too slow for inner loops.
/// Source: Dekker, A floating-point technique for extending the available precision (1971); Joldes, Muller, Popescu,
/// Tight and rigorous error bounds for double-word arithmetic (2017): each operation below has a relative error under
/// 2^-102, barring overflow and underflow.
struct DoubleDouble {
  double high = 0, low = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double h) : high(h) {}
  constexpr DoubleDouble(double h, double l) : high(h), low(l) {}

  explicit operator double() const { return high + low; }
};

/// Returns a + b exactly (Knuth's two-sum).
inline DoubleDouble ExactSum(double a, double b) {
  const double s = a + b;
  const double bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

/// Returns a b exactly, barring underflow.
inline DoubleDouble ExactProduct(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

/// Returns the sum of two doubles with |a| >= |b| exactly (Dekker's fast two-sum).
inline DoubleDouble QuickSum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// Returns the upper 26 bits of x; the other 27 are x - Head(x), exactly. Products of two heads are exact.
inline double Head(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0x7ffffff});
}

/// Returns a b with a relative error under 2^-104 and without fused operations, barring underflow. Elementary functions
/// use it because they must be equally fast on processors that lack fused operations.
inline DoubleDouble SplitProduct(double a, double b) {
  const double p = a * b, ah = Head(a), al = a - ah, bh = Head(b), bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble s = ExactSum(a.high, b.high), t = ExactSum(a.low, b.low);
  const DoubleDouble v = QuickSum(s.high, s.low + t.high);
  return QuickSum(v.high, t.low + v.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble p = ExactProduct(a.high, b.high);
  return QuickSum(p.high, std::fma(a.high, b.low, std::fma(a.low, b.high, p.low)));
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double q = a.high / b.high;
  const DoubleDouble rest = a - b * DoubleDouble(q);
  return QuickSum(q, rest.high / b.high);
}

/// Returns a / b as accurately as SplitProduct, without fused operations.
inline DoubleDouble SplitQuotient(const DoubleDouble& a, const DoubleDouble& b) {
  const double q = a.high / b.high;
  const DoubleDouble p = SplitProduct(q, b.high);
  return QuickSum(q, (((a.high - p.high) - p.low) + a.low - q * b.low) / b.high);
}

}  // namespace R1
