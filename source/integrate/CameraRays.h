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

/// Where on the lens camera rays start. random: as the sampler has it, and always so but for the grid samplers. spiral:
/// at `lens_samples` places for each place in the pixel, on a spiral of Vogel that is turned and moved on from one
/// place to the next. fixed_spiral: the same spiral everywhere, whose rings can be seen.
enum class LensPattern { random, spiral, fixed_spiral };
inline constexpr std::array lens_pattern_names{"random", "spiral", "fixed_spiral"};
constexpr const auto& NamesOf(LensPattern) { return lens_pattern_names; }

/// What makes a camera more than a pinhole that stands still.
struct CameraEffects {
  R3::Vector motion;    // of the camera while the shutter is open
  double aperture = 0;  // radius of the lens, >= 0
  double focus = 0;     // distance along the axis of the plane that is sharp, > 0 where there is a lens
  LensPattern lens = LensPattern::random;
  int lens_samples = 1;  // of a spiral, >= 1
  // Even moments for each place in the pixel of a grid sampler, >= 1; 1: as the sampler has it.
  int shutter_samples = 1;

  bool HasMotion() const { return !(motion == R3::Vector{}); }
  bool HasLens() const { return aperture > 0; }
  /// How many of a pixel's camera rays go through the same place in it.
  std::uint32_t SamplesOfOnePlace() const {
    const int on_lens = HasLens() && lens != LensPattern::random ? lens_samples : 1;
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    return static_cast<std::uint32_t>(std::min(most, std::int64_t{on_lens} * shutter_samples));
  }
};

/// The side of the greatest n x n of at most `samples`; at least 1.
inline std::uint32_t GridSide(std::uint32_t samples) {
  return std::max(1u, static_cast<std::uint32_t>(std::sqrt(static_cast<double>(samples))));
}

/// A sample of a pixel, which is what a camera ray is made from.
struct PixelSample {
  int column = 0, row = 0;
  RandomKey pixel{0};       // the key of the pixel's random choices
  std::uint32_t index = 0;  // the sample's number in the pixel
};

/// The random choices of a camera ray, all from one set of points so that they are even together: the place in the
/// pixel, then on the lens if there is one, then the time if anything moves. What a scene lacks takes no dimension.
class CameraRays {
 public:
  /// `samples`: of each pixel; one alone goes through its middle. `things_move`: so that rays need a time even if the
  /// camera rests.
  CameraRays(const Camera& camera, const CameraEffects& effects, bool things_move, int width, int height,
             SamplerKind sampler, std::uint32_t samples);

  CameraSample operator()(const PixelSample& of) const {
    CameraSample sample;
    MakeEach(std::span(&of, 1), std::span(&sample, 1));
    return sample;
  }
  /// Makes the rays of at most R1::batch_size samples, which together take less time.
  void MakeEach(std::span<const PixelSample> of, std::span<CameraSample> samples) const {
    (this->*kernel_)(of, samples);
  }

  /// Whether all samples have rays; see CameraSample::HasRay.
  bool SeesEverywhere() const { return camera_.IsPinhole(); }
  /// Which of the kernels was chosen: "pinhole", "lens", "moving pinhole", "moving lens", or the same of a projection.
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
  R2::Vector half_size_;  // of the picture at distance 1
  SamplerKind sampler_;
  std::uint32_t samples_, grid_side_;
  MakeSamples kernel_;
};

}  // namespace ray
