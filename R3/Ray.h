#pragma once

#include <cstdint>

#include "R3/Point.h"

namespace R3 {

struct Departure;

/// A half-line, restricted to the open interval (t_min, t_max). The direction may have any length; t counts in lengths
/// of it, so a ray transformed to another frame keeps its t.
struct Ray {
  Point origin{};
  Vector direction{};
  double t_min = 0, t_max = infinity;  // t_min is below 0 if surfaces may meet at the origin, see Departure.h
  double time = 0;                     // share of the shutter interval, in [0, 1)
  // Primitives in their owner's numbering; -1 means none.
  std::int64_t leaving = -1;        // the ray starts on it and cannot meet it up to leaving_until
  double leaving_until = infinity;  // a t, infinite if the ray never meets that primitive again
  std::int64_t reaching = -1;       // the ray ends on it and cannot meet it before
  // The state that decides about surfaces that meet at the origin, in world space whatever the ray's frame. It must
  // outlive the search. Null unless t_min is below 0.
  const Departure* departure = nullptr;

  Point At(double t) const { return origin + t * direction; }
};

}  // namespace R3
