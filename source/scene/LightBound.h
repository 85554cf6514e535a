#pragma once

#include "R3/Point.h"

namespace ray {

/// What is known of a light before a place on it is chosen.
struct LightBound {
  R3::Point center{};  // of a sphere that holds the light; finite
  double radius = 0;
  double power = 0;               // luminance before fall-off, finite, >= 0; the light is never chosen at 0
  double ca = 0, la = 0, qa = 1;  // it falls off by 1 / (ca + la d + qa d^2), each finite and >= 0; not at all where 0
  bool is_infinite = false;       // then `power` is what arrives everywhere, and place and fall-off do not count
};

}  // namespace ray
