#pragma once

#include <numbers>
#include <optional>

#include "R2/Vector.h"
#include "R3/Box.h"
#include "R3/Ray.h"
#include "source/scene/CameraKind.h"

namespace ray {

/// A camera at `eye`; a pinhole unless `kind` says otherwise. The three directions are unit and perpendicular; `right`
/// is towards x up, or its opposite if the image is mirrored.
struct Camera {
  R3::Point eye;
  R3::Vector towards{0, 0, -1}, up{0, 1, 0}, right{1, 0, 0};
  double xfov = 0.25;      // HALF angle from the axis to the left or right edge, radians, in (0, pi/2)
  double aspect = 0;       // width over height of the view, independent of the pixels; 0: that of the image
  R2::Vector shift{0, 0};  // of the image's center from the axis, to the right and up, in half widths
  const CameraKind* kind = &pinhole_camera;
  // The horizontal extent for other kinds of camera: the whole angle in degrees, or a width. 0: derived from xfov, see
  // Extent.
  double extent = 0;
  double near = 0.01, far = 100;  // stored for the viewer; rays are not clipped

  /// Returns the whole horizontal field of view in degrees, in (0, 180).
  double Fov() const { return 360 / std::numbers::pi * xfov; }
  void SetFov(double degrees) { xfov = degrees / 360 * std::numbers::pi; }
  bool IsMirrored() const { return Dot(Cross(towards, up), right) < 0; }
  bool IsPinhole() const { return !kind->sight; }
  /// Returns `extent`. If that is 0, returns the angle of the pinhole, or the width that it sees `distance` away.
  double Extent(double distance = 1) const;
  /// Copies the view settings beyond a centered pinhole with square pixels: projection, aspect, shift, mirroring.
  void TakeViewOf(const Camera& other);
  /// Returns half the width of the view at distance 1 from the eye.
  double HalfWidth() const;
  /// Returns half the height of an image of width x height pixels, at distance 1 from the eye: tan(xfov) height /
  /// width, or tan(xfov) / aspect if an aspect is given.
  double HalfHeight(int width, int height) const;
  /// Returns the pinhole's ray through a point of the image: x, y in pixels from the lower left corner, not necessarily
  /// integers. The direction is not of unit length.
  R3::Ray Through(double x, double y, int width, int height) const {
    return Through(x, y, width, height, {HalfWidth(), HalfHeight(width, height)});
  }
  /// Returns the ray through a point of the image, given half of its width and height, whose computation takes a
  /// tangent.
  R3::Ray Through(double x, double y, int width, int height, const R2::Vector& half) const {
    const double across = (2 * x / width - 1 + shift.x) * half.x,
                 upward = (2 * y / height - 1) * half.y + shift.y * half.x;
    return {eye, towards + across * right + upward * up};
  }
  /// Returns the sight line through a point of the image for a camera that is not a pinhole; std::nullopt outside of
  /// its view.
  std::optional<SightLine> Sight(double x, double y, int width, int height) const;
  /// Returns the ray through a point of the image for any kind of camera; std::nullopt outside of its view.
  std::optional<R3::Ray> RayThrough(double x, double y, int width, int height) const;
  /// Returns the point of the image at which `p` is seen, as RayThrough counts, perhaps outside of the image; the
  /// inverse of RayThrough, up to rounding; the place nearest to the axis if a shifted panorama sees p twice. std::nullopt
  /// if no ray of the view meets p.
  std::optional<R2::Point> PlaceOf(const R3::Point& p, int width, int height) const;
};

/// A camera looking along `towards` (not zero) with `up` made perpendicular: right = unit(towards x up), up =
/// unit(right x towards). If the two are parallel within 1e-9 rad, or up is zero, the coordinate axis least along
/// `towards` replaces up, and `up_was_replaced` is set. Aiming it again leaves a camera bit-identical.
struct AimedCamera {
  Camera camera;
  bool up_was_replaced = false;
};
AimedCamera Aim(const R3::Point& eye, const R3::Vector& towards, const R3::Vector& up);

/// Returns the course's default camera: looking down -z at the center of `scene` from 3 radii away, xfov 0.25; radius 1
/// for an empty box or a point.
Camera DefaultCamera(const R3::Box& scene);

}  // namespace ray
