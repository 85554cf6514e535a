#include "R3/Expression.h"

#include <cmath>
#include <utility>

#include "R3/ExpressionParser.h"

namespace R3 {
namespace {

double Exp(double x) { return R1::Exp(x); }
double Log(double x) { return R1::Log(x); }
double Sin(double x) { return R1::Sin(x); }
double Cos(double x) { return R1::Cos(x); }
R1::SineCosine SinCos(double x) { return R1::SinCos(x); }
std::pair<Interval, Interval> SinCos(const Interval& x) { return {Sin(x), Cos(x)}; }
double Sqrt(double x) { return std::sqrt(x); }
double Abs(double x) { return std::abs(x); }
double WholePower(double x, std::uint32_t n) { return R1::WholePower(x, n); }
double Hull(double a, double) { return a; }  // two numbers can always be compared

/// Returns true if a is certainly smaller; both orders are false if that is not known.
bool IsBelow(double a, double b) { return a < b; }
bool IsBelow(const Interval& a, const Interval& b) { return a.high < b.low; }
bool MayEqual(double, double) { return false; }
bool MayEqual(const Interval& a, const Interval& b) { return !IsBelow(a, b) && !IsBelow(b, a); }
double Smaller(double a, double b) { return std::min(a, b); }
Interval Smaller(const Interval& a, const Interval& b) { return {std::min(a.low, b.low), std::min(a.high, b.high)}; }

/// The slope of a function that is undefined or jumps: any value.
double Undefined(double) { return std::nan(""); }
Interval Undefined(const Interval&) { return Interval::Whole(); }
bool IsDefinedRoot(double x) { return x >= 0; }
bool IsDefinedRoot(const Interval& x) { return x.low >= 0; }

template <typename N>
Slope<N> operator-(const Slope<N>& a) {
  return {-a.value, -a.slope};
}
template <typename N>
Slope<N> operator+(const Slope<N>& a, const Slope<N>& b) {
  return {a.value + b.value, a.slope + b.slope};
}
template <typename N>
Slope<N> operator-(const Slope<N>& a, const Slope<N>& b) {
  return {a.value - b.value, a.slope - b.slope};
}
template <typename N>
Slope<N> operator*(const Slope<N>& a, const Slope<N>& b) {
  return {a.value * b.value, a.slope * b.value + a.value * b.slope};
}
template <typename N>
Slope<N> operator/(const Slope<N>& a, const Slope<N>& b) {
  const N quotient = a.value / b.value;
  return {quotient, (a.slope - quotient * b.slope) / b.value};
}
template <typename N>
Slope<N> Exp(const Slope<N>& a) {
  const N e = Exp(a.value);
  return {e, e * a.slope};
}
template <typename N>
Slope<N> Log(const Slope<N>& a) {
  return {Log(a.value), a.slope / a.value};
}
template <typename N>
Slope<N> Sin(const Slope<N>& a) {
  const auto [sine, cosine] = SinCos(a.value);
  return {sine, cosine * a.slope};
}
template <typename N>
Slope<N> Cos(const Slope<N>& a) {
  const auto [sine, cosine] = SinCos(a.value);
  return {cosine, -sine * a.slope};
}
template <typename N>
Slope<N> Sqrt(const Slope<N>& a) {
  const N root = Sqrt(a.value);
  return {root, IsDefinedRoot(a.value) ? a.slope / (N(2) * root) : Undefined(a.value)};
}
template <typename N>
Slope<N> WholePower(const Slope<N>& a, std::uint32_t n) {
  const N below = n > 1 ? WholePower(a.value, n - 1) : N(1);
  return {WholePower(a.value, n), N(n) * below * a.slope};
}

// If two values may be equal, either may be the result; the slopes of both are possible. Likewise for |a| = max(a, -a).
template <typename N>
Slope<N> Min(const Slope<N>& a, const Slope<N>& b) {
  const N value = Smaller(a.value, b.value);
  if (MayEqual(a.value, b.value)) return {value, Hull(a.slope, b.slope)};
  return {value, IsBelow(b.value, a.value) ? b.slope : a.slope};
}
template <typename N>
N Min(const N& a, const N& b) {
  return Smaller(a, b);
}
template <typename N>
Slope<N> Abs(const Slope<N>& a) {
  const Slope<N> smaller = Min(a, -a);
  return {Abs(a.value), -smaller.slope};
}

}  // namespace

template <typename Number>
Number Expression::At(const Number& x, const Number& y, const Number& z, std::vector<Number>& values) const {
  values.resize(steps_.size());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    const Number &a = values[step.a], &b = values[step.b];
    values[i] = [&]() -> Number {
      switch (step.operation) {
        case Operation::x:
          return x;
        case Operation::y:
          return y;
        case Operation::z:
          return z;
        case Operation::number:
          return Number(step.number);
        case Operation::negate:
          return -a;
        case Operation::add:
          return a + b;
        case Operation::subtract:
          return a - b;
        case Operation::multiply:
          return a * b;
        case Operation::divide:
          return a / b;
        case Operation::power:
          return WholePower(a, static_cast<std::uint32_t>(step.number));
        case Operation::sin:
          return Sin(a);
        case Operation::cos:
          return Cos(a);
        case Operation::exp:
          return Exp(a);
        case Operation::log:
          return Log(a);
        case Operation::sqrt:
          return Sqrt(a);
        case Operation::abs:
          return Abs(a);
        case Operation::min:
          return Min(a, b);
        case Operation::max:
          return -Min(-a, -b);
      }
      return Number(0.0);
    }();
  }
  return values[result_];
}

template double Expression::At(const double&, const double&, const double&, std::vector<double>&) const;
template Interval Expression::At(const Interval&, const Interval&, const Interval&, std::vector<Interval>&) const;
template Slope<double> Expression::At(const Slope<double>&, const Slope<double>&, const Slope<double>&,
                                      std::vector<Slope<double>>&) const;
template Slope<Interval> Expression::At(const Slope<Interval>&, const Slope<Interval>&, const Slope<Interval>&,
                                        std::vector<Slope<Interval>>&) const;

Expression::Expression(std::string_view text) : text_(text) { ExpressionParser(*this).Parse(); }

Expression::Expression(std::string_view text, const ValueOfName& value_of) : text_(text) {
  ExpressionParser(*this, &value_of).Parse();
}

double Evaluate(std::string_view formula, const ValueOfName& value_of) {
  std::vector<double> values;
  const double value = Expression(formula, value_of).At(0.0, 0.0, 0.0, values);
  if (!std::isfinite(value))
    throw ExpressionError(0, formula.size(),
                          std::isnan(value) ? "this has no value" : "this exceeds the range of a double");
  return value;
}

}  // namespace R3
