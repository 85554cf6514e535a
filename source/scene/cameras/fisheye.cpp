#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "source/scene/Camera.h"

namespace ray {
namespace {

/// Projects equidistantly: angles from the axis are proportional to distances from the image's center. The circle is as
/// wide as the image; nothing is visible around it.
///   source   Bourke, Computer generated angular fisheye projections (2001)
std::optional<SightLine> FisheyeSight(const Camera& camera, const R2::Vector& place) {
  const double radius = std::sqrt(place.x * place.x + place.y * place.y);
  if (!(radius <= 1)) return {};
  const double cosine = radius > 0 ? place.x / radius : 1, sine = radius > 0 ? place.y / radius : 0;
  const auto from_axis = R1::SinCosTurns(radius * camera.Extent() / 720);
  const R3::Vector outward = cosine * camera.right + sine * camera.up,
                   around = cosine * camera.up - sine * camera.right,
                   aside = from_axis.cosine * outward - from_axis.sine * camera.towards;
  return SightLine{camera.eye, from_axis.cosine * camera.towards + from_axis.sine * outward,
                   cosine * aside - sine * around, sine * aside + cosine * around};
}

R2::Vector FisheyePlace(const Camera& camera, const R3::Vector& from_eye) {
  constexpr double half_degrees = 360 / std::numbers::pi;  // of a radian
  const double aside = R1::Hypot(from_eye.x, from_eye.y);
  if (!(aside > 0)) return {};
  const double radius = R1::Atan2(aside, from_eye.z) * half_degrees / camera.Extent();
  return {radius * from_eye.x / aside, radius * from_eye.y / aside};
}

}  // namespace

extern const CameraKind fisheye_camera{
    .name = "fisheye",
    .about =
        "a circle, as wide as the image, in which distances from its center are angles from the axis "
        "(equidistant), up to 360 degrees across; black around it",
    .extent = CameraExtent::angle,
    .is_panoramic = true,
    .sight = FisheyeSight,
    .place = FisheyePlace};

}  // namespace ray
