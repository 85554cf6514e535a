#pragma once

#include <memory>
#include <span>

#include "source/accelerate/Accelerator.h"
#include "source/integrate/TraceSettings.h"
#include "source/integrate/TraceState.h"

namespace ray {

/// A camera ray with the key of its random choices.
struct CameraSample {
  R3::Ray ray;
  SampleIndex index;
  double x = 0, y = 0;  // place where it crosses the image, in pixels from the lower left corner

  /// Returns true if the camera sees anything there; otherwise no ray is traced, and the sample is black.
  bool HasRay() const { return ray.t_max > 0; }
};

/// The computation of an image's colors from camera rays.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Computes the radiance along each camera ray, per channel, linear. Rays of neighboring pixels should be passed
  /// together, so that they and their shadow rays are traced together; the results are the same.
  virtual void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const = 0;

  /// Adds the light that the samples share, if Li, with state.shared, has left any there.
  virtual void AddShared(std::span<R2::Color> /*radiances*/, TraceState& /*state*/) const {}
};

/// One line of integrators.def.
struct IntegratorKind {
  const char* about;
  /// `world` and `accelerator` must outlive the result.
  std::unique_ptr<const Integrator> (*make)(const World& world, const Accelerator& accelerator,
                                            const TraceSettings& settings);
  bool shows_costs = false;  // displays HeatColor instead of light or surfaces
};

}  // namespace ray
