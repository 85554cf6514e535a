#pragma once

namespace ray {

/// The estimate of a quantity that cannot be negative, from a measurement that noise may have made negative.
struct PositiveGuess {
  double mean = 0;
  // derivative of the mean by the measurement: 1 if that is exact, 0 if it contains no information
  double slope = 0;
};

/// Estimates a quantity that has the mean `expected`, > 0, from an unbiased measurement `measured` with normally
/// distributed noise of `variance`, > 0.
///   source     if only the mean of a positive quantity is known, the exponential distribution assumes least (Jaynes,
///              Information theory and statistical mechanics, 1957, section 2). Multiplied by the likelihood of the
///              measurement, it becomes a normal distribution around measured - variance / expected, truncated below 0.
///              The slope is that distribution's variance divided by that of the noise (Efron, Tweedie's formula and
///              selection bias, 2011, eq. 2.8).
///   accuracy   1e-10 of the mean and of 1, for standard deviations of the noise of 1e-6 to 1e6 times `expected`
PositiveGuess GuessPositive(double measured, double variance, double expected);

}  // namespace ray
