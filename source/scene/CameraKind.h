#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "R2/Vector.h"
#include "R3/Point.h"

namespace ray {

struct Camera;

/// A camera ray before it has a lens and a time. In focus is what the focus distance times `direction` leads to, so the
/// length of that says along what the distance counts.
struct SightLine {
  R3::Point origin;
  R3::Vector direction;
  R3::Vector across, upward;  // unit, in the plane of the lens, to the right and up in the picture
};

/// What the number behind the name of a projection says.
enum class CameraExtent { none, angle, width };

/// One line of cameras.def: how the places of a picture become rays.
struct CameraKind {
  const char* name;
  const char* about;
  CameraExtent extent = CameraExtent::none;
  bool is_panoramic = false;  // an angle may be as wide as 360 degrees; else it is below 180
  double aspect = 0;  // width over height of what is seen, whatever the picture and the camera say; 0: as these say
  bool has_lens = true;
  /// What is seen at a place, in half widths to the right of the axis and up; nothing outside of the view. Null for the
  /// pinhole, whose rays Camera::Through makes.
  std::optional<SightLine> (*sight)(const Camera& camera, const R2::Vector& place) = nullptr;
};

extern const CameraKind pinhole_camera;

/// Every kind, in the order of cameras.def.
std::span<const CameraKind* const> CameraKinds();
/// Null when no kind has the name.
const CameraKind* FindCameraKind(std::string_view name);
std::vector<std::string_view> CameraKindNames();

/// Whether a camera of the kind can see so many degrees across, or be so wide.
bool IsExtent(const CameraKind& kind, double extent);
/// What it can: "an angle above 0 and up to 360 degrees".
const char* RangeOfExtent(const CameraKind& kind);

}  // namespace ray
