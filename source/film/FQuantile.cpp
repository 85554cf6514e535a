#include "source/film/FQuantile.h"

#include <math.h>  // lgamma_r, which unlike std::lgamma has no global sign

#include <array>
#include <cmath>
#include <limits>

namespace ray {
namespace {

double LogGamma(double x) {
  int sign;
  return lgamma_r(x, &sign);
}

/// The continued fraction of the incomplete beta function, which converges fast below its mean.
///   source   DLMF 8.17.22, evaluated as Lentz, Generating Bessel functions in Mie scattering calculations (1976)
double BetaFraction(double a, double b, double x) {
  constexpr double tiny = std::numeric_limits<double>::min();
  constexpr int most_steps = 100000;  // some sqrt(a + b) are needed
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

/// The regularized incomplete beta function I_x(a, b), x and y = 1 - x in (0, 1).
double IncompleteBeta(double a, double b, double x, double y) {
  const double log_front = LogGamma(a + b) - LogGamma(a) - LogGamma(b) + a * std::log(x) + b * std::log(y);
  const double front = std::exp(log_front);
  if (x < (a + 1) / (a + b + 2)) return front * BetaFraction(a, b, x) / a;
  return 1 - front * BetaFraction(b, a, y) / b;
}

}  // namespace

double FQuantile(double p, double m, double n) {
  // In log f, where the distribution is nearly symmetric.
  double low = -700, high = 700;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2, odds = m * std::exp(middle) / n;
    const double x = odds / (1 + odds), y = 1 / (1 + odds);
    const bool is_below = x <= 0 || (y > 0 && IncompleteBeta(m / 2, n / 2, x, y) < p);
    (is_below ? low : high) = middle;
  }
  return std::exp((low + high) / 2);
}

}  // namespace ray
