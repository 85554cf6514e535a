#pragma once

namespace R3 {

/// Enough of a crossing to choose the nearest, and to find the rest of it once chosen.
struct Hit {
  double t = 0;
  double u = 0, v = 0;  // barycentric coordinates: weights of a triangle's second and third corner
  int part = 0;         // which face of a shape that has several; each shape says its own
};

}  // namespace R3
