#pragma once

#include <algorithm>
#include <array>

#include "R2/Point.h"
#include "R3/Vector.h"

/// Functions shared by shapes whose points are sampled uniformly by area.
namespace R3 {

template <std::size_t parts>
double Sum(const std::array<double, parts>& areas) {
  double sum = 0;
  for (const double area : areas) sum += area;
  return sum;
}

/// One part of a surface, chosen by its share of the area, and random numbers to sample a point on it.
struct DrawnPart {
  int part = 0;
  R2::Point u;  // in [0, 1)^2, uniform again
};

/// Chooses among parts by their areas, not all 0, by the first of the numbers, and rescales that to be uniform again.
template <std::size_t parts>
DrawnPart DrawPart(const std::array<double, parts>& areas, const R2::Point& u) {
  constexpr double below_one = 1 - 0x1p-53;
  const double target = u.x * Sum(areas);
  double before = 0;
  DrawnPart drawn;
  for (std::size_t i = 0; i < parts; ++i) {
    if (areas[i] == 0) continue;
    drawn = {static_cast<int>(i), {std::clamp((target - before) / areas[i], 0.0, below_one), u.y}};
    before += areas[i];
    if (target < before) break;
  }
  return drawn;
}

}  // namespace R3
