#pragma once

#include <array>

#include "tests/Quad.h"

namespace oracle {

/// How far a line passes from a triangle's outline, positive inside; and where it meets the plane.
struct TriangleCrossing {
  Quad inside, t, cosine;

  TriangleCrossing(const std::array<Vector, 3>& corners, const Line& line) {
    std::array<Vector, 3> c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = corners[i] - line.o;
    const Vector& d = line.d;
    const Vector n = Cross(c[1] - c[0], c[2] - c[0]);
    const Quad towards = Dot(n, d), side = towards < 0 ? -1 : 1;
    t = Dot(n, c[0]) / towards;
    cosine = Abs(towards) / (Length(n) * Length(d));
    for (std::size_t i = 0; i < 3; ++i) {
      // The distance of two lines, by their common perpendicular.
      const Vector& from = c[i];
      const Vector across = Cross(c[(i + 1) % 3] - from, d);
      const Quad distance = side * Dot(across, from) / Length(across);
      if (i == 0 || distance < inside) inside = distance;
    }
  }
};

}  // namespace oracle
