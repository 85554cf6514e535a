#include "source/scene/CameraKind.h"

namespace ray {

extern const CameraKind pinhole_camera{"pinhole", "perspective: straight lines stay straight; below 180 degrees",
                                       CameraExtent::angle};

}  // namespace ray
