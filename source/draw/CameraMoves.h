#pragma once

#include <optional>

#include "R2/Point.h"
#include "R3/Box.h"
#include "source/draw/Drawing.h"
#include "source/scene/Camera.h"

/// Camera movements. Each function returns a new camera with the same field of view and an orthonormal basis. Drags are
/// fractions of the drawing's width (x) and height (y, upward positive), as in the course.
namespace ray {

/// The size of a drawing in pixels, both at least 1.
struct DrawingSize {
  int width = 1, height = 1;
  friend bool operator==(const DrawingSize&, const DrawingSize&) = default;
};

/// Rotates eye and directions about an axis through `center`, so that the center keeps its pixel.
///   axis    any length except 0
///   angle   radians, by the right-hand rule
Camera Turned(const Camera& camera, const R3::Point& center, const R3::Vector& axis, double angle);
/// Rotates as in the course: about the axis towards x (right x + up y) by 4 (|x| + |y|) radians.
Camera Rotated(const Camera& camera, const R3::Point& center, const R2::Point& drag);
/// Rotates like a turntable: about `vertical` by 4 x, then up or down by 4 y, stopping short of the poles, where the
/// horizon would flip.
Camera RotatedUpright(const Camera& camera, const R3::Point& center, const R3::Vector& vertical, const R2::Point& drag);
/// Zooms as in the course: f = exp(2 (x + y)), eye += (center - eye) (f - 1) / f.
Camera Zoomed(const Camera& camera, const R3::Point& center, const R2::Point& drag);
/// Moves sideways, so that a point `depth` in front of the eye moves in the image as far as the pointer.
Camera Panned(const Camera& camera, double depth, const R2::Point& drag, const DrawingSize& size);
/// Moves by an offset along right, up and towards.
Camera Moved(const Camera& camera, const R3::Vector& way);
/// Rotates about the eye: sideways about `vertical`, then up or down.
Camera Looking(const Camera& camera, const R3::Vector& vertical, const R2::Point& drag);
/// Moves back along the axis so that the box fills 0.9 of the image in its larger extent.
Camera Framed(const Camera& camera, const R3::Box& box, const DrawingSize& size);
/// Views `center` from the same distance along an axis: towards (a unit vector), with `up`.
Camera FromAxis(const Camera& camera, const R3::Point& center, const R3::Vector& towards, const R3::Vector& up);
/// Multiplies the field of view; xfov stays within [0.005, 1.5].
Camera WithAngle(const Camera& camera, double factor);

/// Returns the place of a point in pixels from the lower left corner; std::nullopt for points that are not in front.
std::optional<R2::Point> PixelOf(const Camera& camera, const R3::Point& p, const DrawingSize& size);
/// Returns the distance of a point from the eye along the axis.
double DepthOf(const Camera& camera, const R3::Point& p);

/// Returns the projection of the camera. Near and far planes enclose the box; those of the scene file are ignored.
ClipMatrix ClipFromDrawing(const Camera& camera, const DrawingSpace& space, const R3::Box& box,
                           const DrawingSize& size);

}  // namespace ray
