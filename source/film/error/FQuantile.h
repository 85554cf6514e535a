#pragma once

namespace ray {

/// Returns the value f that the ratio of two independent mean squares of m and n degrees of freedom does not exceed
/// with probability p: Fisher and Snedecor's F. It is the square of Student's t at 2 p - 1 for m = 1.
///   p          in (0, 1)
///   m, n       above 0
///   accuracy   1e-9 of the value for up to 1e6 degrees of freedom
double FQuantile(double p, double m, double n);

}  // namespace ray
