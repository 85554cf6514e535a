#pragma once

#include <optional>
#include <string>

#include "source/scene/Camera.h"

namespace ray {

/// Returns the camera as a line of a .scn file that reads back as a bit-identical camera:
///     camera ex ey ez  tx ty tz  ux uy uz  xfov  near far [view aspect shift_x shift_y [mirrored]] [projection name
///     [extent]]
std::string CameraLine(const Camera& camera);
/// Parses such a line; std::nullopt if it is not one.
std::optional<Camera> ReadCameraLine(const std::string& text);

}  // namespace ray
