#include "source/app/CameraLine.h"

#include "source/app/Words.h"

namespace ray {
namespace {

template <class Triple>
std::string Text(const Triple& t) {
  return ToText(t.x) + " " + ToText(t.y) + " " + ToText(t.z);
}

}  // namespace

std::string CameraLine(const Camera& camera) {
  return "camera " + Text(camera.eye) + "  " + Text(camera.towards) + "  " + Text(camera.up) + "  " +
         ToText(camera.xfov) + "  " + ToText(camera.near) + " " + ToText(camera.far);
}

}  // namespace ray
