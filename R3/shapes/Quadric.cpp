#include "R3/shapes/Quadric.h"

#include <algorithm>

#include "R1/DoubleDouble.h"

namespace R3 {
namespace {

/// Returns |origin - center|^2 - radius^2 with a relative error of a few u however near the two are.
double PowerOfPoint(const Point& origin, const Point& center, double radius) {
  DoubleDouble sum = -ExactProduct(radius, radius);
  const auto add = [&](double o, double c) {
    const DoubleDouble f = ExactSum(o, -c);
    sum = sum + f * f;
  };
  add(origin.x, center.x);
  add(origin.y, center.y);
  add(origin.z, center.z);
  return static_cast<double>(sum);
}

/// Returns (origin - center) . direction as if computed in twice the precision, then rounded.
/// Source: Ogita, Rump, Oishi, Accurate sum and dot product (2005), algorithm 5.3.
double AccurateDot(const Point& origin, const Point& center, const Vector& direction) {
  double sum = 0, rest = 0;
  const auto add = [&](double o, double c, double d) {
    const DoubleDouble f = ExactSum(o, -c), product = ExactProduct(f.high, d), s = ExactSum(sum, product.high);
    sum = s.high;
    rest += s.low + (product.low + f.low * d);
  };
  add(origin.x, center.x, direction.x);
  add(origin.y, center.y, direction.y);
  add(origin.z, center.z, direction.z);
  return sum + rest;
}

}  // namespace

std::optional<Roots> ScaledQuadricRoots(const Point& origin, const Vector& direction, const Point& center,
                                        double radius) {
  if (!IsFinite(direction) || !IsFinite(origin - center) || !(radius < infinity)) return {};
  const double longest = MaxComponent(Abs(direction)), size = std::max(MaxComponent(Abs(origin - center)), radius);
  if (!(longest > 0) || !(size > 0)) return {};
  const int per_t = std::ilogb(longest), per_length = std::ilogb(size);
  const auto roots = QuadricRoots(ScaledByPower(origin, -per_length), ScaledByPower(direction, -per_t),
                                  ScaledByPower(center, -per_length), std::scalbn(radius, -per_length));
  if (!roots) return {};
  return Roots{std::scalbn(roots->first, per_length - per_t), std::scalbn(roots->second, per_length - per_t)};
}

// The chord to the far side must be accurate to the last digits too, so a and b must lose nothing either.
R3_USES_FMA
Quadratic QuadraticNearby(const Point& origin, const Vector& direction, const Point& center, double radius) {
  const double a = AccurateDot(Point{} + direction, {}, direction);
  const double b = -AccurateDot(origin, center, direction);
  const double c = PowerOfPoint(origin, center, radius);
  return {a, b, c, DifferenceOfProducts(b, b, a, c)};
}

R3_USES_FMA
std::optional<Roots> QuadricRoots(const Point& origin, const Vector& direction, const Point& center, double radius) {
  return QuadricRootsInline(origin, direction, center, radius);
}

}  // namespace R3
