#pragma once

#include <array>

#include "R2/ImageFile.h"
#include "source/draw/CameraMoves.h"

namespace ray {

/// The conversion of radiance to displayed values.
struct Exposure {
  double factor = 1;
  bool srgb = false;
  R2::Quantization quantization = R2::Quantization::rounded;  // of pixels of images
};

/// The viewpoint of a scene, in its drawing space.
struct PreviewView {
  std::array<float, 3> eye{};
  /// The vector to the lower left corner, and the vectors from there to the lower right and the upper left one.
  std::array<std::array<float, 3>, 3> directions{};
  Exposure exposure;
};

PreviewView ViewFrom(const Camera& camera, const DrawingSpace& space, const DrawingSize& size,
                     const Exposure& exposure);

}  // namespace ray
