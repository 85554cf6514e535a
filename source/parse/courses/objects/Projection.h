#pragma once

#include "source/parse/document/Mapping.h"
#include "source/scene/Camera.h"

namespace ray {

/// Takes `projection`, a name of cameras.def, from the mapping of a camera, and with it `fov`, a whole angle across in
/// degrees, or `viewWidth` of an orthographic one. Where none of these is given the camera stays what it is.
void ReadProjection(Mapping& mapping, Camera& camera);

}  // namespace ray
