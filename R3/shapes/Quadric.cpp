#include "R3/shapes/Quadric.h"

#include <algorithm>
#include <utility>

#include "R1/DoubleDouble.h"

namespace R3 {
namespace {

// Nearer to the surface than this share of the radius, (F - r)(F + r) has lost three bits and more.
constexpr double near_share = 0x1p-3;

/// |origin - center|^2 - radius^2 with a relative error of a few u however near the two are.
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

/// (origin - center) . direction as if in twice the precision, then rounded.
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

/// The same for lengths whose squares leave the range of doubles, or nearly.
std::optional<Roots> ScaledRoots(const Point& origin, const Vector& direction, const Point& center, double radius) {
  if (!IsFinite(direction) || !IsFinite(origin - center) || !(radius < infinity)) return {};
  const double longest = MaxComponent(Abs(direction)), size = std::max(MaxComponent(Abs(origin - center)), radius);
  if (!(longest > 0) || !(size > 0)) return {};
  const int per_t = std::ilogb(longest), per_length = std::ilogb(size);
  const auto roots = QuadricRoots(ScaledByPower(origin, -per_length), ScaledByPower(direction, -per_t),
                                  ScaledByPower(center, -per_length), std::scalbn(radius, -per_length));
  if (!roots) return {};
  return Roots{std::scalbn(roots->first, per_length - per_t), std::scalbn(roots->second, per_length - per_t)};
}

}  // namespace

R3_USES_FMA
std::optional<Roots> QuadricRoots(const Point& origin, const Vector& direction, const Point& center, double radius) {
  const Vector f = origin - center;
  double a = Dot(direction, direction), b = -Dot(f, direction);
  const double square = Dot(f, f), distance = std::sqrt(square);
  if (!IsInRange(a) || !IsInRange(std::max(square, radius * radius))) [[unlikely]]
    return ScaledRoots(origin, direction, center, radius);

  double c, discriminant;  // of a t^2 - 2 b t + c
  if (std::abs(distance - radius) < near_share * radius) {
    // The chord to the far side is as long as the bar allows for least error: a and b must lose nothing either.
    a = AccurateDot(Point{} + direction, {}, direction);
    b = -AccurateDot(origin, center, direction);
    c = PowerOfPoint(origin, center, radius);
    discriminant = DifferenceOfProducts(b, b, a, c);
  } else {
    c = (distance - radius) * (distance + radius);
    const double s = b / a;  // to the line's point nearest to the center; fma keeps what is left of f after cancelling
    const Vector miss{std::fma(s, direction.x, f.x), std::fma(s, direction.y, f.y), std::fma(s, direction.z, f.z)};
    const double miss_distance = std::sqrt(Dot(miss, miss));
    discriminant = a * ((radius - miss_distance) * (radius + miss_distance));
  }
  if (!(discriminant >= 0) || !(a > 0)) return {};
  const double q = b + std::copysign(std::sqrt(discriminant), b);
  if (q == 0) return Roots{0, 0};  // the origin is the point of a tangent
  Roots roots{c / q, q / a};
  if (roots.first > roots.second) std::swap(roots.first, roots.second);
  return roots;
}

}  // namespace R3
