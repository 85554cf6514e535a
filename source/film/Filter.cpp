#include "source/film/Filter.h"

#include <cmath>
#include <numbers>

#include "R1/Elementary.h"

namespace ray {
namespace {

// The error of linear interpolation is at most f'' / 8 / steps^2, and no f'' here exceeds 6.
constexpr int steps_per_pixel = 1024;

double RadiusOf(FilterKind kind) {
  switch (kind) {
    case FilterKind::box:
      return 0.5;
    case FilterKind::gaussian:
    case FilterKind::mitchell:
      return 2;
    case FilterKind::lanczos:
      return 3;
  }
  return 0;
}

double Sinc(double x) {
  const double angle = std::numbers::pi * x;
  return angle == 0 ? 1 : R1::Sin(angle) / angle;
}

double Mitchell(double x) {
  constexpr double B = 1.0 / 3, C = 1.0 / 3;
  if (x < 1) return ((12 - 9 * B - 6 * C) * x * x * x + (-18 + 12 * B + 6 * C) * x * x + (6 - 2 * B)) / 6;
  return ((-B - 6 * C) * x * x * x + (6 * B + 30 * C) * x * x + (-12 * B - 48 * C) * x + (8 * B + 24 * C)) / 6;
}

}  // namespace

double FilterFormula(FilterKind kind, double distance) {
  const double x = std::abs(distance), radius = RadiusOf(kind);
  if (!(x < radius)) return 0;
  switch (kind) {
    case FilterKind::box:
      return 1;
    case FilterKind::gaussian:
      return R1::Exp(-2 * x * x) - R1::Exp(-2 * radius * radius);
    case FilterKind::mitchell:
      return Mitchell(x);
    case FilterKind::lanczos:
      return Sinc(x) * Sinc(x / radius);
  }
  return 0;
}

Filter::Filter(FilterKind kind) : kind_(kind), radius_(RadiusOf(kind)) {
  if (IsBox()) return;
  const int last = static_cast<int>(radius_) * steps_per_pixel;
  for (int i = 0; i <= last; ++i) table_.push_back(FilterFormula(kind, static_cast<double>(i) / steps_per_pixel));
}

double Filter::operator()(double distance) const {
  const double x = std::abs(distance);
  if (!(x < radius_)) return 0;
  if (IsBox()) return 1;
  const double step = x * steps_per_pixel;
  const auto below = static_cast<std::size_t>(step);
  const double share = step - static_cast<double>(below);
  return (1 - share) * table_[below] + share * table_[below + 1];
}

}  // namespace ray
