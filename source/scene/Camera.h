#pragma once

#include <numbers>
#include <optional>

#include "R2/Vector.h"
#include "R3/Box.h"
#include "R3/Ray.h"
#include "source/scene/CameraKind.h"

namespace ray {

/// A camera at `eye`; a pinhole, unless `kind` says otherwise. The three directions are unit and perpendicular; `right`
/// is towards x up, or its opposite where the picture is mirrored.
struct Camera {
  R3::Point eye;
  R3::Vector towards{0, 0, -1}, up{0, 1, 0}, right{1, 0, 0};
  double xfov = 0.25;      // HALF angle from the axis to the left or right edge, radians, in (0, pi/2)
  double aspect = 0;       // width over height of what is seen, whatever the pixels; 0: that of the picture
  R2::Vector shift{0, 0};  // of the picture's middle off the axis, to the right and up, in half widths
  const CameraKind* kind = &pinhole_camera;
  // What a camera of another kind sees across: its whole angle in degrees, or a width. 0: as xfov has it, see Extent.
  double extent = 0;
  double near = 0.01, far = 100;  // kept for the viewer; rays are not clipped

  /// The whole horizontal field of view in degrees, in (0, 180).
  double Fov() const { return 360 / std::numbers::pi * xfov; }
  void SetFov(double degrees) { xfov = degrees / 360 * std::numbers::pi; }
  bool IsMirrored() const { return Dot(Cross(towards, up), right) < 0; }
  bool IsPinhole() const { return !kind->sight; }
  /// `extent`, or where that is 0: the angle of the pinhole; or the width of what that sees `distance` away.
  double Extent(double distance = 1) const;
  /// Takes over what a picture is besides what square pixels around a pinhole's axis make it: projection, aspect,
  /// shift, mirroring.
  void TakeViewOf(const Camera& other);
  /// Half the width of what is seen at distance 1 from the eye.
  double HalfWidth() const;
  /// Half the height of a picture of width x height pixels, at distance 1 from the eye: tan(xfov) height / width, or
  /// tan(xfov) / aspect where that is given.
  double HalfHeight(int width, int height) const;
  /// The ray of the pinhole through a place of the picture: x, y in pixels from the lower left corner, not necessarily
  /// whole. The direction is not of unit length.
  R3::Ray Through(double x, double y, int width, int height) const {
    return Through(x, y, width, height, {HalfWidth(), HalfHeight(width, height)});
  }
  /// The ray through a place of the image when half of its width and height are known, which take a tangent to find.
  R3::Ray Through(double x, double y, int width, int height, const R2::Vector& half) const {
    const double across = (2 * x / width - 1 + shift.x) * half.x,
                 upward = (2 * y / height - 1) * half.y + shift.y * half.x;
    return {eye, towards + across * right + upward * up};
  }
  /// What is seen through a place of the picture, of a camera that is no pinhole; nothing outside of its view.
  std::optional<SightLine> Sight(double x, double y, int width, int height) const;
  /// The ray through a place of the picture, of any kind of camera; nothing outside of its view.
  std::optional<R3::Ray> RayThrough(double x, double y, int width, int height) const;
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
