#include <numbers>

#include "R1/Elementary.h"
#include "source/scene/Camera.h"

namespace ray {
namespace {

constexpr double radians_of_half_a_degree = std::numbers::pi / 360;

/// Projects onto an upright cylinder around the eye: columns are angles, rows are heights on it, in perspective. Pixels
/// of the middle row are square.
std::optional<SightLine> CylinderSight(const Camera& camera, const R2::Vector& place) {
  const double extent = camera.Extent();
  const auto along = R1::SinCosTurns(place.x * extent / 720);
  const R3::Vector level = along.cosine * camera.towards + along.sine * camera.right;
  return SightLine{camera.eye, level + radians_of_half_a_degree * extent * place.y * camera.up,
                   along.cosine * camera.right - along.sine * camera.towards, camera.up};
}

R2::Vector CylinderPlace(const Camera& camera, const R3::Vector& from_eye) {
  const double half =
      radians_of_half_a_degree * camera.Extent();  // of the angle, and of the width of the unit cylinder
  return {R1::Atan2(from_eye.x, from_eye.z) / half, from_eye.y / R1::Hypot(from_eye.x, from_eye.z) / half};
}

}  // namespace

extern const CameraKind cylinder_camera{
    .name = "cylinder",
    .about = "columns are angles, up to 360 degrees across, rows are in perspective: upright lines stay straight",
    .extent = CameraExtent::angle,
    .is_panoramic = true,
    .sight = CylinderSight,
    .place = CylinderPlace};

}  // namespace ray
