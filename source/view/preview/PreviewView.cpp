#include "source/view/preview/PreviewView.h"

namespace ray {
namespace {

std::array<float, 3> Single(const R3::Vector& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace

PreviewView ViewFrom(const Camera& camera, const DrawingSpace& space, const DrawingSize& size,
                     const Exposure& exposure) {
  const auto towards = [&](double x, double y) { return camera.Through(x, y, size.width, size.height).direction; };
  const R3::Vector corner = towards(0, 0), across = towards(size.width, 0) - corner,
                   upward = towards(0, size.height) - corner;
  return {space.At(camera.eye), {Single(corner), Single(across), Single(upward)}, exposure};
}

}  // namespace ray
