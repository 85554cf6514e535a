#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "R2/Vector.h"
#include "R3/Point.h"

namespace ray {

struct Camera;

/// A camera ray before lens and time are chosen. Points at the focus distance times `direction` are in focus, so the
/// length of `direction` determines along which axis the distance is measured.
struct SightLine {
  R3::Point origin;
  R3::Vector direction;
  R3::Vector across, upward;  // unit, in the plane of the lens, to the right and up in the image
};

/// The meaning of the number after the name of a projection.
enum class CameraExtent { none, angle, width };

/// One line of cameras.def: a projection that maps points of the image to rays.
struct CameraKind {
  const char* name;
  const char* about;
  CameraExtent extent = CameraExtent::none;
  bool is_panoramic = false;  // the angle may be up to 360 degrees; otherwise it is below 180
  double aspect = 0;  // fixed width over height of the view; 0: given by image and camera
  bool has_lens = true;
  /// Returns the sight line at a point of the image, in half widths to the right of the axis and up; std::nullopt
  /// outside of the view. Null for the pinhole, whose rays are computed by Camera::Through.
  std::optional<SightLine> (*sight)(const Camera& camera, const R2::Vector& place) = nullptr;
  /// Returns the place, in half widths, at which a point is seen, given from the eye along `right`, `up` and `towards`;
  /// arbitrary for a point that no sight line meets. Null for the pinhole.
  R2::Vector (*place)(const Camera& camera, const R3::Vector& from_eye) = nullptr;
};

extern const CameraKind pinhole_camera;

/// Returns all kinds, in the order of cameras.def.
std::span<const CameraKind* const> CameraKinds();
/// Returns the kind with the given name, or null.
const CameraKind* FindCameraKind(std::string_view name);
std::vector<std::string_view> CameraKindNames();

/// Returns true if a camera of the kind can have this angle in degrees or this width.
bool IsExtent(const CameraKind& kind, double extent);
/// Returns the valid range: "an angle above 0 and up to 360 degrees".
const char* RangeOfExtent(const CameraKind& kind);

}  // namespace ray
