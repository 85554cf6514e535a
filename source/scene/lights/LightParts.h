#pragma once

#include <span>
#include <string>
#include <vector>

#include "R2/Color.h"
#include "R3/Point.h"
#include "R3/ShapeKind.h"
#include "source/scene/LightBound.h"

/// Functions shared by several kinds of light.
namespace ray {

using ArgumentList = std::vector<R3::Argument>;

// The arguments of a light in a scene file, in the usual order.
inline ArgumentList operator+(ArgumentList a, const ArgumentList& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
inline ArgumentList ColorArguments() { return {{"r", false}, {"g", false}, {"b", false}}; }
inline ArgumentList PlaceArguments() { return {{"px"}, {"py"}, {"pz"}}; }
inline ArgumentList DirectionArguments() { return {{"dx"}, {"dy"}, {"dz"}}; }
inline ArgumentList FalloffArguments() { return {{"ca", false}, {"la", false}, {"qa", false}}; }

// Their values from the argument `first` on.
inline R2::Color ColorAt(std::span<const double> a, std::size_t first) {
  return {a[first], a[first + 1], a[first + 2]};
}
inline R3::Point PlaceAt(std::span<const double> a, std::size_t first) {
  return {a[first], a[first + 1], a[first + 2]};
}
/// Returns the direction in three arguments; throws R3::ArgumentError if it is 0 0 0.
inline R3::Vector DirectionAt(std::span<const double> a, std::size_t first) {
  const R3::Vector direction{a[first], a[first + 1], a[first + 2]};
  if (direction == R3::Vector{}) throw R3::ArgumentError(first, "the light's direction must not be 0 0 0");
  return direction;
}

/// The attenuation of a light with distance: 1 / (constant + linear d + quadratic d^2).
struct Falloff {
  double constant = 1, linear = 0, quadratic = 0;

  /// Returns the attenuated color; unchanged if the sum is 0, which three zeros mean.
  R2::Color operator()(const R2::Color& color, double distance) const {
    const double sum = constant + linear * distance + quadratic * distance * distance;
    return sum > 0 ? color / sum : color;
  }

  LightBound BoundOf(const R2::Color& color, const R3::Point& center, double radius) const {
    return {center, radius, Luminance(color), constant, linear, quadratic, false};
  }
};
inline Falloff FalloffAt(std::span<const double> a, std::size_t first) {
  return {a[first], a[first + 1], a[first + 2]};
}

// Numbers in the descriptions of lights, in the shortest form that reads back the same, whatever the locale.
std::string Words(double number);
std::string Words(const R2::Color& color);
std::string Words(const R3::Point& place);
std::string Words(const R3::Vector& direction);

}  // namespace ray
