#pragma once

#include <memory>

#include "R2/Color.h"
#include "source/accelerate/Counts.h"
#include "source/integrate/Integrator.h"

namespace ray {

/// What a ray cost, in things looked at: nodes, cells or leaves gone through, and primitives asked.
double Heat(const Counts& cost);

/// Sees, in place of light, what another integrator's camera rays cost: in all channels alike, the heat of each ray and
/// its descendants, or how many these are. Rays go one by one, so that each pixel pays for its own.
class CostIntegrator : public Integrator {
 public:
  CostIntegrator(std::unique_ptr<const Integrator> traced, bool counts_rays)
      : traced_(std::move(traced)), counts_rays_(counts_rays) {}

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> costs, TraceState& state) const override;

 private:
  std::unique_ptr<const Integrator> traced_;
  bool counts_rays_;
};

/// A cost as a color on one scale for all pictures, so that they can be compared: black at 1 and below, then blue at
/// 10, red at 100, yellow at 1,000, white at 10,000 and above, evenly in the logarithm between.
R2::Color HeatColor(double heat);
/// The cost from 1 to 10,000 whose color is the nearest.
double HeatOf(const R2::Color& color);

}  // namespace ray
