#pragma once

#include "source/integrate/Integrator.h"
#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// Shows a property of the first surface that each camera ray hits, and traces no further.
class FirstHit : public Integrator {
 public:
  FirstHit(const World& world, const Accelerator& accelerator) : world_(world), accelerator_(accelerator) {}

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override;

 protected:
  const World& world() const { return world_; }

 private:
  virtual R2::Color Seen(const ShadingPoint& p) const = 0;
  /// Returns the color of rays that hit nothing.
  virtual R2::Color Missed(const R3::Vector&) const { return {}; }
  R2::Color SeenBy(const CameraSample& sample, const std::optional<WorldHit>& hit, TraceState& state) const;

  const World& world_;
  const Accelerator& accelerator_;
};

/// Returns the distance of a point's surface from the eye.
inline double DistanceFromEye(const ShadingPoint& p) { return p.hit.t * Length(p.direction); }

/// Implements `make` of an IntegratorKind without settings.
template <typename Kind>
std::unique_ptr<const Integrator> MakeFirstHit(const World& world, const Accelerator& accelerator,
                                               const TraceSettings&) {
  return std::make_unique<Kind>(world, accelerator);
}

}  // namespace ray
