#include "source/film/error/FQuantile.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "R1/Elementary.h"

namespace ray {
namespace {

/// Returns the logarithm of gamma(x), x > 0, with an error of a few ulp of the larger of it and 1.
///   source   Stirling's series, DLMF 5.11.1; from 10 on its next term, 1 / (156 x^13), is under 1e-15. Below that,
///            gamma(x + 1) = x gamma(x)
double LogGamma(double x) {
  double product = 1;
  for (; x < 10; ++x) product *= x;
  const double z = 1 / (x * x);
  const double series =
      1.0 / 12 - z * (1.0 / 360 - z * (1.0 / 1260 - z * (1.0 / 1680 - z * (1.0 / 1188 - z * (691.0 / 360360)))));
  const double half_log_two_pi = 0.5 * R1::Log(2 * std::numbers::pi);
  return (x - 0.5) * R1::Log(x) - x + half_log_two_pi + series / x - R1::Log(product);
}

/// Evaluates the continued fraction of the incomplete beta function, which converges fast below its mean.
///   source   DLMF 8.17.22, evaluated as Lentz, Generating Bessel functions in Mie scattering calculations (1976)
double BetaFraction(double a, double b, double x) {
  constexpr double tiny = std::numeric_limits<double>::min();
  constexpr int most_steps = 100000;  // about sqrt(a + b) are needed
  const auto away_from_zero = [](double value) { return std::abs(value) < tiny ? tiny : value; };
  double c = 1, d = 1 / away_from_zero(1 - (a + b) * x / (a + 1)), fraction = d;
  for (int m = 1; m < most_steps; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    double change = 1;
    for (const double term : std::array{even, odd}) {
      d = 1 / away_from_zero(1 + term * d);
      c = away_from_zero(1 + term / c);
      change = c * d;
      fraction *= change;
    }
    if (std::abs(change - 1) < std::numeric_limits<double>::epsilon()) break;
  }
  return fraction;
}

/// Evaluates the regularized incomplete beta function I_x(a, b), x and y = 1 - x in (0, 1).
double IncompleteBeta(double a, double b, double x, double y) {
  const double log_front = LogGamma(a + b) - LogGamma(a) - LogGamma(b) + a * R1::Log(x) + b * R1::Log(y);
  const double front = R1::Exp(log_front);
  if (x < (a + 1) / (a + b + 2)) return front * BetaFraction(a, b, x) / a;
  return 1 - front * BetaFraction(b, a, y) / b;
}

}  // namespace

double FQuantile(double p, double m, double n) {
  // Bisects in log f, where the distribution is nearly symmetric.
  double low = -700, high = 700;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2, odds = m * R1::Exp(middle) / n;
    const double x = odds / (1 + odds), y = 1 / (1 + odds);
    const bool is_below = x <= 0 || (y > 0 && IncompleteBeta(m / 2, n / 2, x, y) < p);
    (is_below ? low : high) = middle;
  }
  return R1::Exp((low + high) / 2);
}

}  // namespace ray
