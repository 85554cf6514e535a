#pragma once

#include <string>

#include "source/scene/Camera.h"

namespace ray {

/// The camera as a line of a scene file, with digits enough that it is read back to the bit.
std::string CameraLine(const Camera& camera);

}  // namespace ray
