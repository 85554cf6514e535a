#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "source/scene/Camera.h"

namespace ray {
namespace {

/// Projects to longitudes (columns) and latitudes (rows) with the axis in the middle, as in environment maps: rendering
/// such a map reproduces it. Nothing is visible beyond the poles, which a shifted image can reach.
std::optional<SightLine> LatlongSight(const Camera& camera, const R2::Vector& place) {
  const double latitude = place.y / 2, longitude = place.x / 2;  // turns
  if (!(std::abs(latitude) <= 0.25)) return {};
  const auto around = R1::SinCosTurns(longitude), upward = R1::SinCosTurns(latitude);
  const R3::Vector level = around.cosine * camera.towards + around.sine * camera.right;
  return SightLine{camera.eye, upward.cosine * level + upward.sine * camera.up, camera.right, camera.up};
}

R2::Vector LatlongPlace(const Camera&, const R3::Vector& from_eye) {
  const double level = R1::Hypot(from_eye.x, from_eye.z);
  return {R1::Atan2(from_eye.x, from_eye.z) / std::numbers::pi, R1::Atan2(from_eye.y, level) / std::numbers::pi};
}

}  // namespace

extern const CameraKind latlong_camera{
    .name = "latlong",
    .about =
        "the whole sphere: columns are longitudes, rows latitudes, as in an environment map; twice as wide as "
        "high, pixels of the middle row are square. It has no angle and no lens",
    .aspect = 2,
    .has_lens = false,
    .sight = LatlongSight,
    .place = LatlongPlace};

}  // namespace ray
