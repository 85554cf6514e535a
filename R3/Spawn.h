#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "R3/Numeric.h"
#include "R3/Point.h"

namespace R3 {

/// NextUp(x) where `way` is above 0, NextDown(x) where it is below, else x.
inline double NextAlong(double x, double way) {
  const double mirrored = way < 0 ? -x : x;                        // so that the next is up
  const std::uint64_t one = mirrored > 0 ? 1 : ~std::uint64_t{0};  // modulo 2^64: of -0 it is not used
  const double beyond = std::bit_cast<double>(std::bit_cast<std::uint64_t>(mirrored) + one);
  const double from_0 = mirrored == 0 ? std::numeric_limits<double>::denorm_min() : beyond;
  const double next = mirrored < infinity ? from_0 : mirrored;
  const double back = way < 0 ? -next : next;
  return way < 0 ? back : way > 0 ? back : x;
}

/// SpawnPoint of a place with this error on a surface with unit normal n, compiled into loops over many of them.
inline Point SpawnedFrom(const Point& place, const Vector& error, const Vector& n, const Vector& direction) {
  // How far the corners of the error box reach along the normal.
  const double reach = Dot(Abs(n), error);
  const double side = Dot(n, direction) < 0 ? -1 : 1;
  const Vector way = side * reach * n;
  const Point to = place + way;
  return {NextAlong(to.x, way.x), NextAlong(to.y, way.y), NextAlong(to.z, way.z)};
}

}  // namespace R3
