#pragma once

#include "R3/Box.h"
#include "R3/Ray.h"

namespace ray {

/// A pinhole at `eye`. The three directions are unit and perpendicular.
struct Camera {
  R3::Point eye;
  R3::Vector towards{0, 0, -1}, up{0, 1, 0}, right{1, 0, 0};
  double xfov = 0.25;             // HALF angle from the axis to the left or right edge, radians, in (0, pi/2)
  double near = 0.01, far = 100;  // kept for the viewer; rays are not clipped

  /// The ray through a place of the picture: x, y in pixels from the lower left corner, not necessarily whole.
  /// Vertical: tan(yfov) = tan(xfov) height / width. The direction is not of unit length.
  R3::Ray Through(double x, double y, int width, int height) const;
};

/// A camera looking along `towards` (not zero) with `up` straightened: right = unit(towards x up),
/// up = unit(right x towards). If the two are parallel within 1e-9 rad, or up is zero, the coordinate axis least along
/// `towards` replaces up, and `up_was_replaced` is set. Aimed again, a camera stays as it is to the bit.
struct AimedCamera {
  Camera camera;
  bool up_was_replaced = false;
};
AimedCamera Aim(const R3::Point& eye, const R3::Vector& towards, const R3::Vector& up);

/// The course's: looking down -z at the middle of `scene` from 3 radii away, xfov 0.25; radius 1 for an empty box or a
/// point.
Camera DefaultCamera(const R3::Box& scene);

}  // namespace ray
