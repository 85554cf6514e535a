#include "R3/Warp.h"

#include <algorithm>
#include <cmath>

#include "R1/Elementary.h"

namespace R3 {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

Vector SamplePhongLobe(const R2::Point& u, double n) {
  // The cosine to the power n + 1 is uniform in [0, 1]. At 0, which only u = 1 gives, its logarithm is still finite, so
  // that a huge n does not cause NaN.
  const double logarithm = R1::Log1p(-std::min(u.x, 1 - 0x1p-53)) / (n + 1);
  return FromPolar(std::sqrt(-R1::Expm1(2 * logarithm)), R1::Exp(logarithm), u.y);
}

double PhongLobePdf(double cosine, double n) {
  if (!(cosine >= 0)) return 0;
  return (n + 1) / (2 * pi) * R1::CosinePower(cosine, n);
}

Vector SampleUniformSphere(const R2::Point& u) { return SampleUniformCone(u, 2); }

}  // namespace R3
