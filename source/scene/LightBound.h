#pragma once

#include "R3/Box.h"

namespace ray {

/// What is known of a light before a place on it is chosen.
struct LightBound {
  R3::Point center{};  // of a sphere that holds the light; finite
  double radius = 0;
  double power = 0;               // luminance before fall-off, >= 0 or infinite; the light is never chosen at 0
  double ca = 0, la = 0, qa = 1;  // it falls off by 1 / (ca + la d + qa d^2), each finite and >= 0; not at all where 0
  bool is_infinite = false;       // then `power` is what arrives everywhere, and place and fall-off do not count
};

/// Bound of a light in the box whose power does not fall off with distance.
inline LightBound BoundWithoutFalloff(const R3::Box& box, double power) {
  constexpr double rounding_of_box = 1 + 0x1p-40;
  return {.center = box.Center(), .radius = rounding_of_box * box.Radius(), .power = power, .ca = 1, .la = 0, .qa = 0};
}

}  // namespace ray
