#include "source/film/denoise/PositiveGuess.h"

#include <cmath>
#include <numbers>

#include "R1/Elementary.h"

namespace ray {
namespace {

/// Returns the mean, in standard deviations, of the normal distribution around z that is truncated below 0: z + phi(z)
/// / Phi(z), with phi the density and Phi the distribution of normal noise.
double MeanAbove0(double z) {
  constexpr double far = 3;
  if (z < -far) {
    // Laplace's continued fraction, DLMF 7.9.3; from 3 on, 100 terms are exact up to rounding.
    double fraction = -z;
    for (int k = 100; k > 1; --k) fraction = k / fraction - z;
    return 1 / fraction;
  }
  constexpr double surely = 9;  // Phi(-9) = 1e-19
  if (z > surely) return z;
  // Marsaglia, Evaluating the normal distribution (2004), section 3.
  double sum = z;
  for (double k = 3, term = z; std::abs(term) > 1e-18 * std::abs(sum); k += 2) sum += term *= z * z / k;
  const double phi = R1::Exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
  return z + phi / (0.5 + phi * sum);
}

}  // namespace

PositiveGuess GuessPositive(double measured, double variance, double expected) {
  const double deviation = std::sqrt(variance);
  const double z = measured / deviation - deviation / expected;
  const double mean = MeanAbove0(z);
  return {deviation * mean, 1 - (mean - z) * mean};
}

}  // namespace ray
