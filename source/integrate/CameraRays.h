#pragma once

#include "source/integrate/Integrator.h"
#include "source/scene/Camera.h"

namespace ray {

/// What makes a camera more than a pinhole that stands still.
struct CameraEffects {
  R3::Vector motion;    // of the camera while the shutter is open
  double aperture = 0;  // radius of the lens, >= 0
  double focus = 0;     // distance along the axis of the plane that is sharp, > 0 where there is a lens

  bool HasMotion() const { return !(motion == R3::Vector{}); }
  bool HasLens() const { return aperture > 0; }
};

/// The random choices of a camera ray, all from one set of points so that they are even together: the place in the
/// pixel, then on the lens if there is one, then the time if anything moves. What a scene lacks takes no dimension.
class CameraRays {
 public:
  /// `samples`: of each pixel; one alone goes through its middle. `things_move`: so that rays need a time even if the
  /// camera rests.
  CameraRays(const Camera& camera, const CameraEffects& effects, bool things_move, int width, int height,
             SamplerKind sampler, std::uint32_t samples);

  /// Sample `index` of the pixel in a column and a row. `pixel` is the key of its random choices.
  CameraSample operator()(int column, int row, const RandomKey& pixel, std::uint32_t index) const {
    return (this->*kernel_)(column, row, pixel, index);
  }

  /// Which of the kernels was chosen: "pinhole", "lens", "moving pinhole", "moving lens".
  const char* Kernel() const;

 private:
  template <bool has_lens, bool has_time>
  CameraSample At(int column, int row, const RandomKey& pixel, std::uint32_t index) const;

  Camera camera_;
  CameraEffects effects_;
  bool has_time_;
  int width_, height_;
  SamplerKind sampler_;
  std::uint32_t samples_;
  CameraSample (CameraRays::*kernel_)(int, int, const RandomKey&, std::uint32_t) const;
};

}  // namespace ray
