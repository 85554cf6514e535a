#pragma once

namespace ray {

/// What a quantity that cannot be negative is, by a measurement that noise may have made so.
struct PositiveGuess {
  double mean = 0;
  double slope = 0;  // by how much the mean grows with the measurement: 1 where that is exact, 0 where it tells nothing
};

/// The quantity is expected to be `expected` on average, > 0; that it is measured as `measured`, true on average, with
/// normally distributed noise of `variance`, > 0.
///   source     of a positive quantity of which the mean alone is known the exponential distribution assumes least
///              (Jaynes, Information theory and statistical mechanics, 1957, section 2). Times the likelihood of the
///              measurement that is a normal distribution around measured - variance / expected, cut off below 0. The
///              slope is that distribution's variance over that of the noise (Efron, Tweedie's formula and selection
///              bias, 2011, eq. 2.8).
///   accuracy   1e-10 of the mean and of 1, for deviations of noise that are 1e-6 to 1e6 times what is expected
PositiveGuess GuessPositive(double measured, double variance, double expected);

}  // namespace ray
