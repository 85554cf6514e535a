#include "source/draw/preview/PreviewView.h"

#include "source/draw/Drawing.h"

namespace ray {

PreviewView ViewFrom(const Camera& camera, const DrawingSpace& space, const DrawingSize& size,
                     const Exposure& exposure) {
  const auto towards = [&](double x, double y) { return camera.Through(x, y, size.width, size.height).direction; };
  const R3::Vector corner = towards(0, 0), across = towards(size.width, 0) - corner,
                   upward = towards(0, size.height) - corner;
  return {space.At(camera.eye), {AsFloats(corner), AsFloats(across), AsFloats(upward)}, exposure};
}

}  // namespace ray
