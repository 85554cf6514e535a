#pragma once

#include <memory>

#include "R2/Color.h"
#include "source/accelerate/Counts.h"
#include "source/integrate/Integrator.h"

namespace ray {

/// Returns the cost of a ray: the number of visited nodes, cells and leaves plus the number of tested primitives.
double Heat(const Counts& cost);

/// Shows the cost of another integrator's camera rays instead of their light: the heat of each ray and its descendants,
/// or their number, equal in all channels. Rays are traced one at a time, so that each pixel has its own cost.
class CostIntegrator : public Integrator {
 public:
  CostIntegrator(std::unique_ptr<const Integrator> traced, bool counts_rays)
      : traced_(std::move(traced)), counts_rays_(counts_rays) {}

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> costs, TraceState& state) const override;

 private:
  std::unique_ptr<const Integrator> traced_;
  bool counts_rays_;
};

/// Returns the color of a cost, on one scale for all images so that they can be compared: black at 1 and below, blue at
/// 10, red at 100, yellow at 1,000, white at 10,000 and above, interpolated in the logarithm.
R2::Color HeatColor(double heat);
/// Returns the cost from 1 to 10,000 with the nearest color.
double HeatOf(const R2::Color& color);

}  // namespace ray
