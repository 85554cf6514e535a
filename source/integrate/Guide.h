#pragma once

#include <array>
#include <span>

#include "source/integrate/Whitted.h"

namespace ray {

/// The noise-free result of a camera ray, without the noise of shadows, for a denoiser.
///   0..2   its light as in mode whitted, with the same mirrored and refracted rays, but without shadows and from the
///          middle of each light; at most 16 in each channel. Rays with a throughput below a tenth are skipped
///   3..5   albedo of the first surface: kd times texture plus kr plus kt; the background's color without a surface
///   6..8   its shading normal on the viewer's side; 0 0 0 without a surface
///   9      its nearness, 1 / (1 + distance); 0 without a surface
using Guide = std::array<double, 10>;

class GuideTracer {
 public:
  /// Both must outlive it.
  GuideTracer(const World& world, const Accelerator& accelerator, const TraceSettings& settings);

  /// Computes the guides of at most 16 camera rays. The guide of a ray does not depend on the others.
  void Trace(std::span<const CameraSample> samples, std::span<Guide> guides, TraceState& state) const;
  static constexpr std::size_t most_at_once = 16;

 private:
  /// The recursion of mode whitted over surfaces that are lit without noise.
  class Unshadowed : public Whitted {
   public:
    using Whitted::Whitted;

   private:
    void Shade(std::span<ShadingPoint> points, std::span<R2::Color> radiances, TraceState& state) const override;
  };

  const World& world_;
  const Unshadowed unshadowed_;
};

}  // namespace ray
