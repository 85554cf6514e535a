#include "source/scene/Camera.h"

#include <cmath>

#include "R1/Elementary.h"

namespace ray {
namespace {

// Directions that are unit and perpendicular within this error are treated as exact.
constexpr double rounding = 8 * 0x1p-53;

bool IsUnit(const R3::Vector& v) { return std::abs(Dot(v, v) - 1) <= rounding; }

// Below this angle the cross product of two unit vectors is mostly their rounding error: 1e-9 rad leaves seven good
// digits.
constexpr double parallel_angle = 1e-9;

}  // namespace

void Camera::TakeViewOf(const Camera& other) {
  aspect = other.aspect;
  shift = other.shift;
  kind = other.kind;
  extent = other.extent;
  if (IsMirrored() != other.IsMirrored()) right = -right;
}

double Camera::HalfWidth() const { return R1::Tan(xfov); }

double Camera::HalfHeight(int width, int height) const {
  return aspect > 0 ? HalfWidth() / aspect : HalfWidth() * height / width;
}

double Camera::Extent(double distance) const {
  if (extent > 0) return extent;
  return kind->extent == CameraExtent::width ? 2 * HalfWidth() * distance : Fov();
}

namespace {

/// Returns half the height of an image, in half widths.
double HalfHeightInWidths(const Camera& camera, int width, int height) {
  const double seen = camera.kind->aspect > 0 ? camera.kind->aspect : camera.aspect;
  return seen > 0 ? 1 / seen : static_cast<double>(height) / width;
}

}  // namespace

std::optional<SightLine> Camera::Sight(double x, double y, int width, int height) const {
  const double half_height = HalfHeightInWidths(*this, width, height);
  return kind->sight(*this, {2 * x / width - 1 + shift.x, (2 * y / height - 1) * half_height + shift.y});
}

std::optional<R3::Ray> Camera::RayThrough(double x, double y, int width, int height) const {
  if (IsPinhole()) return Through(x, y, width, height);
  const auto sight = Sight(x, y, width, height);
  if (!sight) return {};
  return R3::Ray{sight->origin, sight->direction};
}

std::optional<R2::Point> Camera::PlaceOf(const R3::Point& p, int width, int height) const {
  const R3::Vector d = p - eye, from_eye{Dot(d, right), Dot(d, up), Dot(d, towards)};
  const double half = from_eye.z * HalfWidth();  // of the pinhole's view, at that depth
  const R2::Vector place =
      IsPinhole() ? R2::Vector{from_eye.x / half, from_eye.y / half} : kind->place(*this, from_eye);
  const R2::Point at{width * (place.x - shift.x + 1) / 2,
                     height * ((place.y - shift.y) / HalfHeightInWidths(*this, width, height) + 1) / 2};
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return {};
  const auto ray = RayThrough(at.x, at.y, width, height);
  return ray && Dot(p - ray->origin, ray->direction) > 0 ? std::optional(at) : std::nullopt;
}

AimedCamera Aim(const R3::Point& eye, const R3::Vector& towards, const R3::Vector& up) {
  AimedCamera aimed;
  Camera& c = aimed.camera;
  c.eye = eye;
  c.towards = IsUnit(towards) ? towards : Unit(towards);
  R3::Vector across = Cross(c.towards, Unit(up));
  if (!(Length(across) > parallel_angle)) {
    const R3::Vector a = Abs(c.towards);
    const R3::Vector axis = a.y <= a.x && a.y <= a.z ? R3::Vector{0, 1, 0}
                            : a.z <= a.x             ? R3::Vector{0, 0, 1}
                                                     : R3::Vector{1, 0, 0};
    across = Cross(c.towards, axis);
    aimed.up_was_replaced = true;
  }
  const bool is_straight = IsUnit(up) && std::abs(Dot(up, c.towards)) <= rounding;
  c.up = is_straight ? up : Unit(Cross(Unit(across), c.towards));
  c.right = Unit(Cross(c.towards, c.up));
  return aimed;
}

Camera DefaultCamera(const R3::Box& scene) {
  const double half_diagonal = scene.Radius();
  const double radius = half_diagonal > 0 ? half_diagonal : 1;
  const R3::Point center = scene.IsEmpty() ? R3::Point{} : scene.Center();
  Camera camera;
  camera.eye = center + R3::Vector{0, 0, 3 * radius};
  camera.near = 0.01 * radius;
  camera.far = 100 * radius;
  return camera;
}

}  // namespace ray
