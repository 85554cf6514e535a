#pragma once

#include <cmath>

namespace R3 {

/// A number of about 106 bits, kept as the unevaluated sum of two doubles, |low| <= ulp(high)/2.
/// For sums and products whose cancellation would otherwise eat the answer; not for inner loops.
/// Source: Dekker, A floating-point technique for extending the available precision (1971);
/// Joldes, Muller, Popescu, Tight and rigorous error bounds for double-word arithmetic (2017): each
/// operation below has a relative error under 2^-102, barring overflow and underflow.
struct Wide {
  double high = 0, low = 0;

  constexpr Wide() = default;
  constexpr Wide(double h) : high(h) {}
  constexpr Wide(double h, double l) : high(h), low(l) {}

  explicit operator double() const { return high + low; }
};

/// a + b exactly (Knuth's two-sum).
inline Wide ExactSum(double a, double b) {
  const double s = a + b;
  const double bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

/// a b exactly, barring underflow.
inline Wide ExactProduct(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

/// Sum of two doubles of which |a| >= |b| (Dekker's fast two-sum).
inline Wide QuickSum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

inline Wide operator-(const Wide& a) { return {-a.high, -a.low}; }

inline Wide operator+(const Wide& a, const Wide& b) {
  const Wide s = ExactSum(a.high, b.high), t = ExactSum(a.low, b.low);
  const Wide v = QuickSum(s.high, s.low + t.high);
  return QuickSum(v.high, t.low + v.low);
}

inline Wide operator-(const Wide& a, const Wide& b) { return a + -b; }

inline Wide operator*(const Wide& a, const Wide& b) {
  const Wide p = ExactProduct(a.high, b.high);
  return QuickSum(p.high, std::fma(a.high, b.low, std::fma(a.low, b.high, p.low)));
}

inline Wide operator/(const Wide& a, const Wide& b) {
  const double q = a.high / b.high;
  const Wide rest = a - b * Wide(q);
  return QuickSum(q, rest.high / b.high);
}

}  // namespace R3
