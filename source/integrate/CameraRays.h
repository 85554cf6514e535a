#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "source/integrate/Integrator.h"
#include "source/scene/Camera.h"

namespace ray {

/// The places on the lens where camera rays start.
///   random         from the sampler; always used except with the grid samplers
///   spiral         `lens_samples` places for each place in the pixel, on a spiral of Vogel that is rotated and
///                  continued
///                  from one place to the next
///   fixed_spiral   the same spiral everywhere, whose rings are visible
enum class LensPattern { random, spiral, fixed_spiral };
inline constexpr std::array lens_pattern_names{"random", "spiral", "fixed_spiral"};
constexpr const auto& NamesOf(LensPattern) { return lens_pattern_names; }

/// The effects of a camera beyond a static pinhole.
struct CameraEffects {
  R3::Vector motion;    // of the camera while the shutter is open
  double aperture = 0;  // radius of the lens, >= 0
  double focus = 0;     // distance along the axis of the plane in focus, > 0 with a lens
  LensPattern lens = LensPattern::random;
  int lens_samples = 1;  // of a spiral, >= 1
  // Even moments for each place in the pixel of a grid sampler, >= 1; 1: from the sampler.
  int shutter_samples = 1;

  bool HasMotion() const { return !(motion == R3::Vector{}); }
  bool HasLens() const { return aperture > 0; }
  /// Returns the number of a pixel's camera rays through the same place in it.
  std::uint32_t SamplesOfOnePlace() const {
    const int on_lens = HasLens() && lens != LensPattern::random ? lens_samples : 1;
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    return static_cast<std::uint32_t>(std::min(most, std::int64_t{on_lens} * shutter_samples));
  }
};

/// Returns the largest n, at least 1, such that n x n is at most `samples`.
inline std::uint32_t GridSide(std::uint32_t samples) {
  return std::max(1u, static_cast<std::uint32_t>(std::sqrt(static_cast<double>(samples))));
}

/// The sample of a pixel that determines a camera ray.
struct PixelSample {
  int column = 0, row = 0;
  RandomKey pixel{0};       // the key of the pixel's random choices
  std::uint32_t index = 0;  // the sample's number in the pixel
};

/// Makes camera rays. The random choices of a ray come from one point, so that they are evenly distributed together:
/// the place in the pixel, then on the lens if there is one, then the time if anything moves. Missing features use no
/// dimension.
class CameraRays {
 public:
  /// `samples`: per pixel; a single one goes through its middle. `things_move`: true if rays need a time even if the
  /// camera is at rest.
  CameraRays(const Camera& camera, const CameraEffects& effects, bool things_move, int width, int height,
             SamplerKind sampler, std::uint32_t samples);

  CameraSample operator()(const PixelSample& of) const {
    CameraSample sample;
    MakeEach(std::span(&of, 1), std::span(&sample, 1));
    return sample;
  }
  /// Makes the rays of at most R1::batch_size samples, which is faster than one at a time.
  void MakeEach(std::span<const PixelSample> of, std::span<CameraSample> samples) const {
    (this->*kernel_)(of, samples);
  }

  /// Returns true if all samples have rays; see CameraSample::HasRay.
  bool SeesEverywhere() const { return camera_.IsPinhole(); }
  /// Returns the name of the kernel: "pinhole", "lens", "moving pinhole", "moving lens", or the same with a projection.
  std::string Kernel() const;

 private:
  R2::Point InPixel(std::uint32_t index, const R2::Point& random) const;
  R2::Point OnLens(const PixelSample& of, const R2::Point& random) const;
  double Moment(std::uint32_t index, double random) const;
  void MoveOnLens(const R2::Point& on_lens, const R3::Vector& across, const R3::Vector& upward, R3::Ray& ray) const;
  R3::Ray Projected(const CameraSample& at, const R2::Point& on_lens) const;
  using MakeSamples = void (CameraRays::*)(std::span<const PixelSample>, std::span<CameraSample>) const;
  template <bool is_pinhole>
  MakeSamples KernelFor() const;
  template <bool is_pinhole, bool has_lens, bool has_time>
  void Make(std::span<const PixelSample> of, std::span<CameraSample> samples) const;

  Camera camera_;
  CameraEffects effects_;
  bool has_time_;
  int width_, height_;
  R2::Vector half_size_;  // of the image at distance 1
  SamplerKind sampler_;
  std::uint32_t samples_, grid_side_;
  MakeSamples kernel_;
};

}  // namespace ray
