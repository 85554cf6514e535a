#include "source/scene/Camera.h"

namespace ray {
namespace {

/// Parallel rays from the plane through the eye: what is behind that is not seen.
std::optional<SightLine> OrthographicSight(const Camera& camera, const R2::Vector& place) {
  const double half = camera.Extent() / 2;
  return SightLine{camera.eye + half * place.x * camera.right + half * place.y * camera.up, camera.towards,
                   camera.right, camera.up};
}

}  // namespace

extern const CameraKind orthographic_camera{
    .name = "orthographic",
    .about =
        "parallel rays, so that sizes do not depend on distances; its number is the width of what is seen, "
        "without one what the pinhole sees at the middle of the scene",
    .extent = CameraExtent::width,
    .sight = OrthographicSight};

}  // namespace ray
