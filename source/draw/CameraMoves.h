#pragma once

#include <optional>

#include "R2/Point.h"
#include "R3/Box.h"
#include "source/draw/Drawing.h"
#include "source/scene/Camera.h"

/// Ways to move a camera. Each returns a new one with the same field of view and an orthonormal basis.
/// Drags are fractions of the drawing's width (x) and height (y, upward positive), as the course counts them.
namespace ray {

/// The size of a drawing in pixels, both at least 1.
struct DrawingSize {
  int width = 1, height = 1;
  friend bool operator==(const DrawingSize&, const DrawingSize&) = default;
};

/// Rotated about an axis through `center`, eye and directions alike, so that the center keeps its pixel.
///   axis    any length but 0
///   angle   radians, by the right-hand rule
Camera Turned(const Camera& camera, const R3::Point& center, const R3::Vector& axis, double angle);
/// The course's: about the axis towards x (right x + up y) by 4 (|x| + |y|) radians.
Camera Rotated(const Camera& camera, const R3::Point& center, const R2::Point& drag);
/// Turns like a turntable: about `vertical` by 4 x, then up or down by 4 y, stopping short of the poles, where the
/// horizon would flip.
Camera RotatedUpright(const Camera& camera, const R3::Point& center, const R3::Vector& vertical, const R2::Point& drag);
/// The course's: f = exp(2 (x + y)), eye += (center - eye) (f - 1) / f.
Camera Zoomed(const Camera& camera, const R3::Point& center, const R2::Point& drag);
/// Moved sideways, so that a point `depth` in front of the eye moves on the picture as far as the pointer.
Camera Panned(const Camera& camera, double depth, const R2::Point& drag, const DrawingSize& size);
/// Moved by an offset along right, up and towards.
Camera Moved(const Camera& camera, const R3::Vector& way);
/// Turned where it stands: sideways about `vertical`, then up or down.
Camera Looking(const Camera& camera, const R3::Vector& vertical, const R2::Point& drag);
/// Set back along its axis so that the box fills 0.9 of the picture where it is widest.
Camera Framed(const Camera& camera, const R3::Box& box, const DrawingSize& size);
/// From the same distance to `center` along an axis: towards (a unit vector), with `up`.
Camera FromAxis(const Camera& camera, const R3::Point& center, const R3::Vector& towards, const R3::Vector& up);
/// With a wider or narrower field of view; xfov stays within [0.005, 1.5].
Camera WithAngle(const Camera& camera, double factor);

/// Where a point appears, in pixels from the lower left corner; nothing for points that are not in front.
std::optional<R2::Point> PixelOf(const Camera& camera, const R3::Point& p, const DrawingSize& size);
/// How far in front of the eye a point is, along the axis.
double DepthOf(const Camera& camera, const R3::Point& p);

/// The projection of the camera. Near and far planes are set around the box, not where the scene file has them.
ClipMatrix ClipFromDrawing(const Camera& camera, const DrawingSpace& space, const R3::Box& box,
                           const DrawingSize& size);

}  // namespace ray
