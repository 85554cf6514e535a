#include "source/scene/Camera.h"

namespace ray {
namespace {

/// Projects along parallel rays from the plane through the eye; points behind it are not visible.
std::optional<SightLine> OrthographicSight(const Camera& camera, const R2::Vector& place) {
  const double half = camera.Extent() / 2;
  return SightLine{camera.eye + half * place.x * camera.right + half * place.y * camera.up, camera.towards,
                   camera.right, camera.up};
}

R2::Vector OrthographicPlace(const Camera& camera, const R3::Vector& from_eye) {
  const double half = camera.Extent() / 2;
  return {from_eye.x / half, from_eye.y / half};
}

}  // namespace

extern const CameraKind orthographic_camera{
    .name = "orthographic",
    .about =
        "parallel rays, so that sizes do not depend on distances; its number is the visible width, "
        "by default that of the pinhole at the middle of the scene",
    .extent = CameraExtent::width,
    .sight = OrthographicSight,
    .place = OrthographicPlace};

}  // namespace ray
