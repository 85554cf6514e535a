#include "source/draw/CameraMoves.h"

#include <algorithm>
#include <cmath>

#include "R1/Elementary.h"

namespace ray {
namespace {

constexpr double radians_across = 4;  // rotation by a drag across the whole drawing
constexpr double filled = 0.9;        // share of the image that a framed box fills
constexpr double narrowest = 0.005, widest = 1.5;

/// Returns a copy of a camera in another pose.
Camera Posed(const Camera& like, const R3::Point& eye, const R3::Vector& towards, const R3::Vector& up) {
  const Camera aimed = Aim(eye, towards, up).camera;
  Camera camera = like;
  camera.eye = aimed.eye;
  camera.towards = aimed.towards;
  camera.up = aimed.up;
  camera.right = aimed.right;
  return camera;
}

double HalfHeight(const Camera& camera, const DrawingSize& size) { return camera.HalfHeight(size.width, size.height); }

/// Returns the vector from the eye to the middle of the image, 1 along the axis.
R3::Vector TowardsMiddle(const Camera& camera) {
  const double half_width = camera.HalfWidth();
  return camera.towards + camera.shift.x * half_width * camera.right + camera.shift.y * half_width * camera.up;
}

/// Returns the tilt, limited so that the view does not reach the vertical.
double AllowedTilt(const Camera& camera, const R3::Vector& vertical, double tilt) {
  constexpr double closest = 0.01;  // minimum angle to a pole in radians
  const double elevation = R1::Asin(std::clamp(Dot(camera.towards, Unit(vertical)), -1.0, 1.0));
  const double most = R1::Acos(0.0) - closest;
  return std::clamp(tilt, std::min(0.0, -most - elevation), std::max(0.0, most - elevation));
}

/// Returns true if the camera looks along the vertical, as axis views do, so that the vertical has no direction in the
/// image.
bool IsAtPole(const Camera& camera, const R3::Vector& vertical) {
  constexpr double nearest = 1e-6;  // angle in radians; drags stop far before
  return Length(Cross(camera.towards, Unit(vertical))) < nearest;
}

}  // namespace

Camera Turned(const Camera& camera, const R3::Point& center, const R3::Vector& axis, double angle) {
  const R3::Vector unit = Unit(axis);
  return Posed(camera, center + R3::Turned(camera.eye - center, unit, angle), R3::Turned(camera.towards, unit, angle),
               R3::Turned(camera.up, unit, angle));
}

Camera Rotated(const Camera& camera, const R3::Point& center, const R2::Point& drag) {
  const R3::Vector axis = Cross(camera.towards, drag.x * camera.right + drag.y * camera.up);
  if (axis == R3::Vector{}) return camera;
  return Turned(camera, center, axis, radians_across * (std::abs(drag.x) + std::abs(drag.y)));
}

Camera RotatedUpright(const Camera& camera, const R3::Point& center, const R3::Vector& vertical,
                      const R2::Point& drag) {
  const Camera around = Turned(camera, center, vertical, -radians_across * drag.x);
  // An upward drag lowers the eye, and so raises the view.
  const double tilt = AllowedTilt(around, vertical, radians_across * drag.y);
  const Camera tilted = Turned(around, center, around.right, tilt);
  return Posed(camera, tilted.eye, tilted.towards, IsAtPole(tilted, vertical) ? tilted.up : vertical);
}

Camera Zoomed(const Camera& camera, const R3::Point& center, const R2::Point& drag) {
  const double factor = R1::Exp(2 * (drag.x + drag.y));
  return Posed(camera, camera.eye + (factor - 1) / factor * (center - camera.eye), camera.towards, camera.up);
}

Camera Panned(const Camera& camera, double depth, const R2::Point& drag, const DrawingSize& size) {
  const double across = 2 * camera.HalfWidth() * depth * drag.x, upward = 2 * HalfHeight(camera, size) * depth * drag.y;
  return Posed(camera, camera.eye - across * camera.right - upward * camera.up, camera.towards, camera.up);
}

Camera Moved(const Camera& camera, const R3::Vector& way) {
  return Posed(camera, camera.eye + way.x * camera.right + way.y * camera.up + way.z * camera.towards, camera.towards,
               camera.up);
}

Camera Looking(const Camera& camera, const R3::Vector& vertical, const R2::Point& drag) {
  const Camera around = Turned(camera, camera.eye, vertical, -radians_across * drag.x);
  const double tilt = AllowedTilt(around, vertical, radians_across * drag.y);
  const Camera tilted = Turned(around, camera.eye, around.right, tilt);
  return Posed(camera, camera.eye, tilted.towards, vertical);
}

Camera Framed(const Camera& camera, const R3::Box& box, const DrawingSize& size) {
  if (box.IsEmpty()) return camera;
  const R3::Point center = box.Center();
  const double half_width = filled * camera.HalfWidth(), half_height = filled * HalfHeight(camera, size);
  double back = 0;
  for (int i = 0; i < 8; ++i) {
    const R3::Vector corner = box.Corner(i) - center;
    const double depth = Dot(corner, camera.towards);
    const R3::Vector off = corner - depth * TowardsMiddle(camera);
    back = std::max({back, std::abs(Dot(off, camera.right)) / half_width - depth,
                     std::abs(Dot(off, camera.up)) / half_height - depth});
  }
  if (!(back > 0)) return camera;  // a point is visible from anywhere
  return Posed(camera, center - back * TowardsMiddle(camera), camera.towards, camera.up);
}

Camera FromAxis(const Camera& camera, const R3::Point& center, const R3::Vector& towards, const R3::Vector& up) {
  const double distance = Length(center - camera.eye);
  return Posed(camera, center - distance * towards, towards, up);
}

Camera WithAngle(const Camera& camera, double factor) {
  Camera other = camera;
  other.xfov = std::clamp(camera.xfov * factor, std::min(camera.xfov, narrowest), std::max(camera.xfov, widest));
  return other;
}

std::optional<R2::Point> PixelOf(const Camera& camera, const R3::Point& p, const DrawingSize& size) {
  const R3::Vector way = p - camera.eye;
  const double depth = Dot(way, camera.towards);
  if (!(depth > 0)) return {};
  const R3::Vector off = way / depth - TowardsMiddle(camera);
  const double across = Dot(off, camera.right) / camera.HalfWidth();
  const double upward = Dot(off, camera.up) / HalfHeight(camera, size);
  return R2::Point{(across + 1) / 2 * size.width, (upward + 1) / 2 * size.height};
}

double DepthOf(const Camera& camera, const R3::Point& p) { return Dot(p - camera.eye, camera.towards); }

ClipMatrix ClipFromDrawing(const Camera& camera, const DrawingSpace& space, const R3::Box& box,
                           const DrawingSize& size) {
  // In units of the drawing space.
  double nearest = 1, farthest = 2;
  if (!box.IsEmpty()) {
    const double middle = DepthOf(camera, box.Center()) / space.radius, radius = box.Radius() / space.radius;
    constexpr double widened = 1.01;
    farthest = std::max(middle + widened * radius, 1e-3);
    nearest = std::max(middle - widened * radius, 1e-3 * farthest);
  }
  const double sx = 1 / camera.HalfWidth(), sy = 1 / HalfHeight(camera, size);
  const R3::Vector eye = (camera.eye - space.center) / space.radius, middle = TowardsMiddle(camera);
  const R3::Vector x = sx * (camera.right - Dot(camera.right, middle) * camera.towards),
                   y = sy * (camera.up - Dot(camera.up, middle) * camera.towards);
  return Perspective(eye, camera.towards, x, y, nearest, farthest);
}

}  // namespace ray
