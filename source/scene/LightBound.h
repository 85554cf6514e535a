#pragma once

#include "R3/Box.h"

namespace ray {

/// The properties of a light that are known before a point on it is chosen.
struct LightBound {
  R3::Point center{};  // of a sphere that contains the light; finite
  double radius = 0;
  double power = 0;               // luminance before attenuation, >= 0 or infinite; at 0 the light is never chosen
  double ca = 0, la = 0, qa = 1;  // attenuation 1 / (ca + la d + qa d^2), each finite and >= 0; none if all are 0
  bool is_infinite = false;       // `power` then arrives everywhere; position and attenuation are ignored
};

/// Returns the bound of a light in the box without attenuation.
inline LightBound BoundWithoutFalloff(const R3::Box& box, double power) {
  constexpr double rounding_of_box = 1 + 0x1p-40;
  return {.center = box.Center(), .radius = rounding_of_box * box.Radius(), .power = power, .ca = 1, .la = 0, .qa = 0};
}

}  // namespace ray
