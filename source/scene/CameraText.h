#pragma once

#include <optional>
#include <string>

#include "source/scene/Camera.h"

namespace ray {

/// The camera as a line of a .scn file that reads back as the same camera to the bit:
///     camera ex ey ez  tx ty tz  ux uy uz  xfov  near far [view aspect shift_x shift_y [mirrored]] [projection name
///     [extent]]
std::string CameraLine(const Camera& camera);
/// Nothing when it is no such line.
std::optional<Camera> ReadCameraLine(const std::string& text);

}  // namespace ray
