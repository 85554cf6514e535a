#pragma once

#include "R2/Color.h"
#include "source/scene/LightBound.h"

namespace ray {

/// How a light's strength lessens with distance: 1 / (constant + linear d + quadratic d^2).
struct Falloff {
  double constant = 1, linear = 0, quadratic = 0;

  /// Undivided where the sum is 0, as all three numbers 0 ask for.
  R2::Color operator()(const R2::Color& color, double distance) const {
    const double sum = constant + linear * distance + quadratic * distance * distance;
    return sum > 0 ? color / sum : color;
  }

  LightBound BoundOf(const R2::Color& color, const R3::Point& center, double radius) const {
    return {center, radius, Luminance(color), constant, linear, quadratic, false};
  }
};

}  // namespace ray
