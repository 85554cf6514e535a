#pragma once

#include <cstddef>

#include "R1/Coefficients.h"

/// Kernels of elementary functions near zero. T is a double, or a vector of doubles with its operators: the same
/// operations in the same order give the same bits.
namespace R1 {

/// Returns c[0] + c[1] x + c[2] x^2 + ... by Horner's rule.
template <class T, std::size_t count>
T Polynomial(const double (&c)[count], T x) {
  T sum = T(c[count - 1]);
  for (std::size_t i = count - 1; i-- > 0;) sum = sum * x + T(c[i]);
  return sum;
}

/// Returns sin(high + low) - high, |high| <= pi/4 and |low| <= ulp(high)/2. Its magnitude is under .11 |high|, so its
/// own rounding errors matter little.
template <class T>
T SineLessAngle(T high, T low) {
  const T z = high * high;
  return high * z * Polynomial(coefficients::sine, z) + low * (T(1) - T(0.5) * z);
}

/// Returns cos(high + low), |high| <= pi/4 and |low| <= ulp(high)/2.
template <class T>
T CosineNearZero(T high, T low) {
  const T z = high * high, half = T(0.5) * z, above = T(1) - half;
  return above + (((T(1) - above) - half) + (z * z * Polynomial(coefficients::cosine, z) - high * low));
}

/// Returns exp(r) - 1 - r, |r| <= log(2)/256.
template <class T>
T ExponentialCurve(T r) {
  return r * r * Polynomial(coefficients::exponential, r);
}

/// Returns (log(1 + r) - r + r^2/2) / r^3, |r| < .0041, by Estrin's scheme, since it is part of a long chain of
/// dependent operations.
template <class T>
T LogarithmCurve(T r) {
  const auto& c = coefficients::logarithm;
  const T square = r * r;
  const T low = (T(c[0]) + T(c[1]) * r) + (T(c[2]) + T(c[3]) * r) * square;
  return low + ((T(c[4]) + T(c[5]) * r) + T(c[6]) * square) * (square * square);
}

/// Returns atan(r) - r, |r| <= 1/31.
template <class T>
T ArctangentLessRatio(T r) {
  const T z = r * r;
  return r * z * Polynomial(coefficients::arctangent, z);
}

}  // namespace R1
