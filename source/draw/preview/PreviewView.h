#pragma once

#include <array>

#include "R2/ImageFile.h"
#include "source/draw/CameraMoves.h"

namespace ray {

/// How radiance becomes what a screen is given.
struct Exposure {
  double factor = 1;
  bool srgb = false;
  R2::Quantization quantization = R2::Quantization::rounded;  // of pixels of images
};

/// From where a scene is seen, in its drawing space.
struct PreviewView {
  std::array<float, 3> eye{};
  /// Towards the lower left corner; what is to be added for the lower right, and for the upper left one.
  std::array<std::array<float, 3>, 3> directions{};
  Exposure exposure;
};

PreviewView ViewFrom(const Camera& camera, const DrawingSpace& space, const DrawingSize& size,
                     const Exposure& exposure);

}  // namespace ray
