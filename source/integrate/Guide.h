#pragma once

#include <array>
#include <span>

#include "source/integrate/Whitted.h"

namespace ray {

/// What a camera ray shows but for the noise of shadows, for a denoiser.
///   0..2   its light as mode whitted has it, with the same mirrored and refracted rays, but without shadows and from
///          the middle of each light; at most 16 in each channel. Rays that matter less than a tenth of it are left out
///   3..5   albedo of the first surface: kd times texture plus kr plus kt; the background's where there is none
///   6..8   its shading normal on the viewer's side; 0 0 0 where there is none
///   9      its nearness, 1 / (1 + distance); 0 where there is none
using Guide = std::array<double, 10>;

class GuideTracer {
 public:
  /// Both must outlive it.
  GuideTracer(const World& world, const Accelerator& accelerator, const TraceSettings& settings);

  /// The guides of some camera rays, at most 16 at once. What a ray gives depends on itself alone.
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
