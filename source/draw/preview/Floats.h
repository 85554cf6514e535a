#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "R2/Color.h"
#include "R3/Vector.h"

/// Numbers in single precision, as a GPU takes them: what is beyond its range becomes the largest there is.
namespace ray {

inline float AsFloat(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -most, most));
}

inline std::array<float, 3> AsFloats(const R2::Color& c) { return {AsFloat(c.r), AsFloat(c.g), AsFloat(c.b)}; }
inline std::array<float, 3> AsFloats(const R3::Vector& v) { return {AsFloat(v.x), AsFloat(v.y), AsFloat(v.z)}; }

}  // namespace ray
