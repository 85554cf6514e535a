#include "source/integrate/modes/FirstHit.h"

namespace ray {
namespace {

/// Nearness: (far - d) / (far - near) for the distance d from the eye, clamped to [0, 1]. White for near surfaces,
/// black for far ones and without a surface.
class ZBuffer : public FirstHit {
 public:
  ZBuffer(const World& world, const Accelerator& accelerator, const ZBufferRange& range)
      : FirstHit(world, accelerator), range_(range) {}

 private:
  R2::Color Seen(const ShadingPoint& p) const override {
    const double length = range_.far - range_.near;
    const double nearness = length > 0 ? R2::Clamped((range_.far - DistanceFromEye(p)) / length) : 1;
    return {nearness, nearness, nearness};
  }

  ZBufferRange range_;
};

}  // namespace

extern const IntegratorKind zbuffer_kind{"nearness of the first surface, from white to black",
                                         [](const World& world, const Accelerator& accelerator,
                                            const TraceSettings& settings) -> std::unique_ptr<const Integrator> {
                                           return std::make_unique<ZBuffer>(world, accelerator, settings.zbuffer);
                                         }};

}  // namespace ray
