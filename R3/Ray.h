#pragma once

#include <cstdint>

#include "R3/Point.h"

namespace R3 {

struct Departure;

/// A half line, cut to the open interval (t_min, t_max). The direction may have any length: t counts in
/// lengths of it, so a ray seen from another frame keeps its t.
struct Ray {
  Point origin{};
  Vector direction{};
  double t_min = 0, t_max = infinity;  // t_min is below 0 where surfaces may meet at the origin, see Departure.h
  double time = 0;                     // when, of the time the shutter is open, in [0, 1)
  // Primitives as their owner numbers them; -1 means none.
  std::int64_t leaving = -1;        // the ray starts on it and cannot meet it up to leaving_until
  double leaving_until = infinity;  // a t, infinite where the ray never meets that primitive again
  std::int64_t reaching = -1;       // the ray ends on it and cannot meet it before
  // What decides about surfaces that meet at the origin, in the world whatever the ray's frame; it must outlive the
  // search. Null where t_min is not below 0.
  const Departure* departure = nullptr;

  Point At(double t) const { return origin + t * direction; }
};

}  // namespace R3
