#include "source/integrate/shading/Refract.h"

namespace ray {

std::optional<R3::Vector> Refract(const R3::Vector& d, const R3::Vector& N, double eta) {
  const R3::Vector across = Cross(d, N);
  const double sine_squared = eta * eta * Dot(across, across);
  const double rest = 1 - sine_squared;
  if (!(rest >= 0)) return {};
  // eta d + (eta cos - sqrt(rest)) N, split into its parts along and across N so that a huge eta does not cancel.
  const R3::Vector along_surface = d - Dot(d, N) * N;
  return Unit(eta * along_surface - std::sqrt(rest) * N);
}

}  // namespace ray
