#include "source/scene/CameraKind.h"

#include <array>
#include <limits>

#include "R1/Kinds.h"

namespace ray {

std::span<const CameraKind* const> CameraKinds() {
#define CAMERA(name) KIND(CameraKind, name##_camera),
  static const std::array kinds{
#include "source/scene/cameras.def"
  };
  return kinds;
}

const CameraKind* FindCameraKind(std::string_view name) { return R1::FindKind(CameraKinds(), name); }

std::vector<std::string_view> CameraKindNames() {
  std::vector<std::string_view> names;
  for (const CameraKind* kind : CameraKinds()) names.emplace_back(kind->name);
  return names;
}

bool IsExtent(const CameraKind& kind, double extent) {
  switch (kind.extent) {
    case CameraExtent::none:
      return false;
    case CameraExtent::angle:
      return extent > 0 && (kind.is_panoramic ? extent <= 360 : extent < 180);
    case CameraExtent::width:
      return extent > 0 && extent <= std::numeric_limits<double>::max();
  }
  return false;
}

const char* RangeOfExtent(const CameraKind& kind) {
  switch (kind.extent) {
    case CameraExtent::none:
      return "no number";
    case CameraExtent::angle:
      return kind.is_panoramic ? "an angle above 0 and up to 360 degrees" : "an angle between 0 and 180 degrees";
    case CameraExtent::width:
      return "a width above 0, in the scene's units";
  }
  return "";
}

}  // namespace ray
