#pragma once

#include <memory>
#include <span>

#include "source/accelerate/Accelerator.h"
#include "source/integrate/TraceSettings.h"
#include "source/integrate/TraceState.h"

namespace ray {

/// A camera ray, and where its random choices come from.
struct CameraSample {
  R3::Ray ray;
  SampleIndex index;
  double x = 0, y = 0;  // where it crosses the picture, in pixels from the lower left corner

  /// Whether the camera sees anything there; else no ray is to be traced, and the sample is black.
  bool HasRay() const { return ray.t_max > 0; }
};

/// What a picture shows of a ray.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// What comes back along each of some camera rays, per channel, linear. Rays of neighboring pixels are best given
  /// together, since they and their shadow rays then are traced together; what each brings back is the same.
  virtual void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const = 0;
};

/// One line of integrators.def.
struct IntegratorKind {
  const char* about;
  /// `world` and `accelerator` outlive what is made.
  std::unique_ptr<const Integrator> (*make)(const World& world, const Accelerator& accelerator,
                                            const TraceSettings& settings);
  bool shows_costs = false;  // in the colors of HeatColor, rather than light or surfaces
};

}  // namespace ray
