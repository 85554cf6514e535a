#pragma once

namespace R3 {

/// The part of a crossing that is needed to choose the nearest one, and to compute the rest once chosen.
struct Hit {
  double t = 0;
  double u = 0, v = 0;  // barycentric coordinates: weights of a triangle's second and third corner
  int part = 0;         // the face, for shapes that have several; numbered by each shape
};

}  // namespace R3
